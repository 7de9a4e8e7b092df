#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>

using namespace undergrowth;

namespace {

constexpr int PROTOTYPES = 64;
constexpr int PLANTS = 300;
constexpr int STEPS = 1500;
constexpr int SETTLED = 300;
/// Of the motions of two plants, each less its mean: the mean over pairs of the correlation.
constexpr double UNISON_BOUND = 0.5;

FieldSimulation prototype_field(Law law, float speed, int count = PLANTS) {
	FieldSettings settings;
	settings.prototypes = PROTOTYPES;
	FieldSimulation field(settings);
	add_plants(field, field.add_species(species_of(law)), count);
	FieldWind wind = wave_wind();
	wind.speed = speed;
	field.set_wind(wind);
	return field;
}

std::vector<double> motion_of(const std::vector<std::vector<double>> &series, size_t plant) {
	std::vector<double> motion;
	double mean = 0.0;
	for (const std::vector<double> &moment : series) {
		motion.push_back(moment[plant]);
		mean += moment[plant];
	}
	mean /= static_cast<double>(series.size());
	for (double &value : motion) {
		value -= mean;
	}
	return motion;
}

double product(const std::vector<double> &a, const std::vector<double> &b) {
	double sum = 0.0;
	for (size_t i = 0; i < a.size(); i++) {
		sum += a[i] * b[i];
	}
	return sum;
}

} // namespace

TEST_CASE("followers show what their prototype did, as long ago as they say") {
	for (const Law law : { Law::elasticity, Law::spring }) {
		FieldSimulation field = prototype_field(law, 20.0f);
		for (int i = 0; i < 1400; i++) {
			field.step();
		}
		const Prototypes &models = *field.prototypes(0);
		for (int i = 0; i < PLANTS; i++) {
			const Follower &follower = field.follower(0, i);
			const Bend *pair = field.page(0).bends() + 2 * i;
			REQUIRE(pair[1] == models.bend(follower.prototype, follower.delay));
			REQUIRE(pair[0] == models.bend(follower.prototype, follower.delay + 1));
			const glm::vec3 root = field.page(0).root(i);
			const float late = field.prototype_lead() + wind_delay(field.wind(), root.x, root.z);
			const float steps = late / FIELD_STEP + static_cast<float>(follower.own_delay);
			REQUIRE(std::fabs(steps - static_cast<float>(follower.delay)) <= 1.0f);
		}
	}
}

TEST_CASE("plants that share prototypes do not move in unison") {
	for (const Law law : { Law::elasticity, Law::spring }) {
		for (const float speed : { 0.0f, 10.0f }) {
			FieldSimulation field = prototype_field(law, speed, 60);
			std::vector<std::vector<double>> series;
			for (int i = 0; i < STEPS; i++) {
				field.step();
				if (i >= SETTLED) {
					series.emplace_back();
					for (int k = 0; k < 60; k++) {
						series.back().push_back(static_cast<double>(field.state(0, k).direction.x));
					}
				}
			}
			double sum = 0.0;
			int pairs = 0;
			for (size_t a = 0; a < 60; a++) {
				for (size_t b = a + 1; b < 60; b++) {
					const std::vector<double> first = motion_of(series, a);
					const std::vector<double> second = motion_of(series, b);
					sum += product(first, second) / std::sqrt(product(first, first) * product(second, second));
					pairs++;
				}
			}
			CAPTURE(sum / pairs);
			CHECK(std::fabs(sum / pairs) < UNISON_BOUND);
		}
	}
}

TEST_CASE("a wind that turns moves followers without a jump") {
	constexpr float JUMP = 0.12f; // Twice the most of a step in a field of settled waves, and some.
	FieldSimulation field = prototype_field(Law::spring, 8.0f);
	std::vector<glm::vec3> before(PLANTS, glm::vec3(0.0f, 1.0f, 0.0f));
	for (int i = 0; i < 1500; i++) {
		if (i == 1000) {
			FieldWind turned = field.wind();
			turned.wind.direction += 1.5f;
			field.set_wind(turned);
		}
		field.step();
		for (int k = 0; k < PLANTS; k++) {
			const glm::vec3 now = decode_bend(field.page(0).bends()[2 * k + 1]);
			if (i > 20) {
				REQUIRE(glm::distance(now, before[static_cast<size_t>(k)]) < JUMP);
			}
			before[static_cast<size_t>(k)] = now;
		}
	}
}

TEST_CASE("plants that lean follow prototypes that lean their way") {
	FieldSettings settings;
	settings.prototypes = PROTOTYPES;
	FieldSimulation field(settings);
	MotionSpecies species = species_of(Law::spring);
	species.lean = 0.3f;
	const int kind = field.add_species(species);
	std::vector<MotionPlant> plants;
	for (int i = 0; i < 32; i++) {
		MotionPlant plant = chance_plant(i);
		const float around = 0.2f * static_cast<float>(i);
		plant.rest = { std::sin(0.3f) * std::sin(around), std::cos(0.3f), std::sin(0.3f) * std::cos(around) };
		plants.push_back(plant);
	}
	field.add_page(kind, plants.data(), 32);
	field.set_wind({ { WindKind::constant, 0.0f }, 0.0f });
	for (int i = 0; i < 100; i++) {
		field.step();
	}
	for (int i = 0; i < 32; i++) {
		const glm::vec3 rest = plants[static_cast<size_t>(i)].rest;
		const glm::vec3 shown = field.state(0, i).direction;
		CHECK(shown.y == doctest::Approx(std::cos(0.3)).epsilon(0.002));
		// Within a sector of an eighth of the circle, and what the even shares differ from angles.
		CHECK(shown.x * rest.x + shown.z * rest.z > 0.75f * std::sin(0.3f) * std::sin(0.3f));
	}
}

TEST_CASE("without followers' bends only prototypes are stepped, and states are the same") {
	FieldSettings settings;
	settings.prototypes = 16;
	settings.write_followers = false;
	FieldSimulation field = mixed_field(settings, 200);
	for (int i = 0; i < 20; i++) {
		field.step();
	}
	CHECK(field.simulated_count() == 32);
	CHECK(field.plant_count() == 400);
	CHECK(field.page(0).bends()[1] == 0u);
	CHECK(field.state(0, 5).direction.y < 1.0f);
	CHECK(field.prototypes(1)->history()[2 * field.prototypes(1)->newest_slot() * Prototypes::MOST + 1] ==
			field.prototypes(1)->bend(0, 0));
}

#include "prototype_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

using namespace undergrowth;

namespace {

constexpr int STEPS = 1500;
constexpr int SETTLED = 300;
/// Mean over pairs of plants of the correlation of their motions, each without its mean.
constexpr double UNISON_BOUND = 0.5;

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

TEST_CASE("the first step runs with the whole history of prototypes") {
	FieldSettings settings;
	settings.prototypes = 8;
	FieldSimulation field = mixed_field(settings, 300);
	CHECK(field.due_count() == 2 * 8 * (Prototypes::SLOTS + 1));
	field.step();
	CHECK(field.due_count() == 2 * 8);
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

TEST_CASE("leaning plants follow prototypes that lean in the same direction") {
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
		// Within a sector of an eighth of the circle, plus the difference of even shares from angles.
		CHECK(shown.x * rest.x + shown.z * rest.z > 0.75f * std::sin(0.3f) * std::sin(0.3f));
	}
}

TEST_CASE("only prototypes are stepped, for any number of followers") {
	FieldSettings settings;
	settings.prototypes = 16;
	FieldSimulation field = mixed_field(settings, 200);
	field.step();
	CHECK(field.simulated_count() == 32);
	CHECK(field.due_count() == 32);
	CHECK(field.plant_count() == 400);
	CHECK(field.state(0, 5).direction.y < 1.0f);
}

TEST_CASE("each step of the history continues at the end of the step before") {
	FieldSettings settings;
	settings.prototypes = 16;
	FieldSimulation field = mixed_field(settings, 10);
	for (int i = 0; i < 100; i++) {
		field.step();
		for (int kind = 0; kind < 2; kind++) {
			const Prototypes &models = *field.prototypes(kind);
			const int slot = models.newest_slot();
			const int last = (slot + Prototypes::SLOTS - 1) % Prototypes::SLOTS;
			for (int k = 0; k < 16; k++) {
				REQUIRE(models.history(0)[2 * (slot * Prototypes::MAX_COUNT + k)] ==
						models.history(0)[2 * (last * Prototypes::MAX_COUNT + k) + 1]);
			}
		}
	}
}

TEST_CASE("prototypes are as short as the shortest plant, as long as the longest, and of lengths between") {
	MotionSpecies species = species_of(Law::spring);
	species.shortest = 0.4f;
	species.longest = 1.2f;
	species.joint.damping_ratio = 1.0f;
	Prototypes models(0, species, PROTOTYPES, FIELD_STEP);
	const FieldWind wind = { { WindKind::constant, 1.0f }, 10.0f };
	for (int i = 0; i < 600; i++) {
		models.step(wind_at_time(wind, 0.0), winds_along(wind));
	}
	const double stiffness = 0.4 * std::pow(2.0 * 3.14159265 * species.joint.natural_frequency, 2.0);
	std::vector<double> lengths;
	for (int i = 0; i < PROTOTYPES; i++) {
		const glm::vec3 bent = newest(models, i);
		lengths.push_back(1.0 / (stiffness * std::hypot(bent.x, bent.z) / bent.y));
	}
	std::sort(lengths.begin(), lengths.end());
	for (int i = 0; i < PROTOTYPES; i++) {
		CHECK(lengths[static_cast<size_t>(i)] == doctest::Approx(0.4 + 0.8 * i / 63.0).epsilon(0.01));
	}
}

TEST_CASE("plants in a row along either axis follow different prototypes with different delays") {
	for (const glm::vec3 row : { glm::vec3(0.37f, 0.0f, 0.0f), glm::vec3(0.0f, 0.0f, 0.37f) }) {
		FieldSettings settings;
		settings.prototypes = PROTOTYPES;
		FieldSimulation field(settings);
		std::vector<MotionPlant> plants(400);
		for (int i = 0; i < 400; i++) {
			plants[static_cast<size_t>(i)].root = static_cast<float>(i) * row;
		}
		field.add_page(field.add_species(species_of(Law::elasticity)), plants.data(), 400);
		std::set<int> prototypes;
		std::set<int> delays;
		for (int i = 0; i < 400; i++) {
			prototypes.insert(field.follower(0, i).prototype);
			delays.insert(field.follower(0, i).own_delay);
		}
		CHECK(prototypes.size() > 60);
		CHECK(delays.size() > 55);
		CHECK(*delays.rbegin() < 60); // One second.
	}
}

TEST_CASE("prototypes of a changed species get the new properties and continue their motion") {
	FieldSettings settings;
	settings.prototypes = PROTOTYPES;
	FieldSimulation field(settings);
	add_plants(field, field.add_species(species_of(Law::elasticity)), 50);
	field.set_wind(wave_wind());
	for (int i = 0; i < 60; i++) {
		field.step();
	}
	MotionSpecies leaning = species_of(Law::spring);
	leaning.lean = 0.4f;
	const glm::vec3 before = newest(*field.prototypes(0), 3);
	field.set_species(0, leaning);
	field.step();
	CHECK(glm::distance(newest(*field.prototypes(0), 3), before) < 0.1f);
	field.set_wind({ { WindKind::constant, 0.0f }, 0.0f });
	for (int i = 0; i < 1200; i++) {
		field.step();
	}
	for (int i = 0; i < PROTOTYPES; i++) {
		CHECK(newest(*field.prototypes(0), i).y == doctest::Approx(std::cos(0.4)).epsilon(0.002));
	}
	std::vector<glm::vec3> rests;
	MotionPlant plant;
	for (int i = 0; i < 50; i++) {
		const float around = 0.12f * static_cast<float>(i);
		rests.emplace_back(std::sin(0.4f) * std::sin(around), std::cos(0.4f), std::sin(0.4f) * std::cos(around));
	}
	field.set_rests(0, 0, rests.data(), 50);
	for (int i = 0; i < 50; i++) {
		plant.root.z = static_cast<float>(i);
		plant.rest = rests[static_cast<size_t>(i)];
		const int added = field.add_page(0, &plant, 1);
		for (const glm::vec3 shown : { field.state(added, 0).direction, field.state(0, i).direction }) {
			CHECK(shown.x * plant.rest.x + shown.z * plant.rest.z > 0.75f * std::sin(0.4f) * std::sin(0.4f));
		}
	}
}

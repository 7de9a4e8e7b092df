#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>

using namespace undergrowth;

namespace {

constexpr int PROTOTYPES = 64;
constexpr int PLANTS = 300;
constexpr int STEPS = 1500;
constexpr int SETTLED = 300;
/// Of the motions of two plants, each less its mean: the mean over pairs of the correlation.
constexpr double UNISON_BOUND = 0.5;
constexpr float SAME = 1e-3f; // Of what halves and a mix of stereographic images leave.
constexpr float NEAR = 0.01f;

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

glm::vec3 newest(const Prototypes &models, int prototype) {
	return from_stereographic(models.bend(prototype, 0.0f, 1.0f));
}

/// Of any plant's direction in one step, in the ten seconds after a wind of waves turns, or slows down.
float most_change(FieldSimulation &field, float turn) {
	float most = 0.0f;
	std::vector<glm::vec3> before(PLANTS);
	for (int i = 0; i < 1600; i++) {
		if (i == 1000) {
			FieldWind changed = field.wind();
			changed.wind.direction += turn;
			changed.speed = turn == 0.0f ? 5.0f : changed.speed;
			field.set_wind(changed);
		}
		field.step();
		for (int k = 0; k < PLANTS; k++) {
			const glm::vec3 now = field.state(0, k).direction;
			most = i > 900 ? std::max(most, glm::distance(now, before[static_cast<size_t>(k)])) : 0.0f;
			before[static_cast<size_t>(k)] = now;
		}
	}
	return most;
}

} // namespace

TEST_CASE("followers show what their prototype did, as long ago as the wind needs to them and as they are late") {
	for (const float speed : { 20.0f, 4.0f, 0.0f }) {
		FieldSimulation field = prototype_field(Law::elasticity, speed);
		std::vector<std::vector<glm::vec3>> did; // By step and prototype.
		for (int i = 0; i < 1400; i++) {
			field.step();
			did.emplace_back();
			for (int k = 0; k < PROTOTYPES; k++) {
				did.back().push_back(newest(*field.prototypes(0), k));
			}
		}
		float most_late = 0.0f;
		for (int i = 0; i < PLANTS; i++) {
			const Follower &follower = field.follower(0, i);
			const glm::vec3 root = field.page(0).root(i);
			const float way = (field.prototype_lead() + wind_delay(field.wind(), root.x, root.z)) / FIELD_STEP;
			const float late = std::min(way, 896.0f) + static_cast<float>(follower.own_delay);
			REQUIRE(way > -0.01f);
			most_late = std::max(most_late, late);
			for (const float fraction : { 0.0f, 0.3f, 1.0f }) {
				const float moment = 1399.0f - late - (1.0f - fraction);
				const auto before = std::min(static_cast<size_t>(moment), did.size() - 2);
				const float part = moment - static_cast<float>(before);
				const glm::vec3 wanted =
						glm::mix(did[before][follower.prototype], did[before + 1][follower.prototype], part);
				REQUIRE(glm::distance(field.shown_direction(0, i, fraction), wanted) < SAME);
			}
			REQUIRE(glm::distance(field.state(0, i).direction, field.shown_direction(0, i, 1.0f)) < 1e-6f);
		}
		CHECK((speed > 0.0f || most_late < 65.0f));
		CHECK((speed != 4.0f || most_late > 900.0f));
	}
}

TEST_CASE("a plant that follows one of its own length moves as one that is simulated, later by its own delay") {
	for (const Law law : { Law::elasticity, Law::spring }) {
		MotionSpecies species = species_of(law);
		species.shortest = species.longest = 0.8f;
		std::vector<MotionPlant> plants(20);
		for (int i = 0; i < 20; i++) {
			plants[static_cast<size_t>(i)] = { chance_plant(i).root, 0.8f, { 0.0f, 1.0f, 0.0f } };
		}
		FieldSettings settings;
		FieldSimulation simulated(settings);
		settings.prototypes = 1;
		FieldSimulation following(settings);
		for (FieldSimulation *field : { &simulated, &following }) {
			field->add_page(field->add_species(species), plants.data(), 20);
			FieldWind wind = wave_wind();
			wind.speed = 15.0f;
			field->set_wind(wind);
		}
		std::vector<std::vector<glm::vec3>> did;
		for (int i = 0; i < 2400; i++) {
			simulated.step();
			following.step();
			did.emplace_back();
			for (int k = 0; k < 20; k++) {
				did.back().push_back(simulated.state(0, k).direction);
				if (i > 2000) {
					const auto then = static_cast<size_t>(i - following.follower(0, k).own_delay);
					REQUIRE(glm::distance(following.state(0, k).direction, did[then][static_cast<size_t>(k)]) < NEAR);
				}
			}
		}
	}
}

TEST_CASE("what followers show goes on from one step to the next") {
	FieldSimulation field = prototype_field(Law::spring, 8.0f);
	field.step();
	for (int i = 0; i < 200; i++) {
		if (i == 100) {
			FieldWind turned = field.wind();
			turned.wind.direction += 1.5f;
			field.set_wind(turned);
		}
		std::vector<glm::vec3> ends;
		for (int k = 0; k < PLANTS; k++) {
			ends.push_back(field.shown_direction(0, k, 1.0f));
		}
		field.step();
		for (int k = 0; k < PLANTS; k++) {
			REQUIRE(glm::distance(field.shown_direction(0, k, 0.0f), ends[static_cast<size_t>(k)]) < 1e-4f);
			const glm::vec3 way = field.shown_direction(0, k, 1.0f) - field.shown_direction(0, k, 0.0f);
			REQUIRE(glm::distance(field.state(0, k).rate, way / FIELD_STEP) <
					0.05f * glm::length(way / FIELD_STEP) + 1e-3f);
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

TEST_CASE("a wind that turns or slows down moves followers by no more in a step than plants that are simulated") {
	constexpr float MORE = 2.0f;
	for (const Law law : { Law::elasticity, Law::spring }) {
		for (const float turn : { 0.5f * 3.14159f, 0.0f }) {
			FieldSimulation simulated((FieldSettings()));
			add_plants(simulated, simulated.add_species(species_of(law)), PLANTS);
			FieldSimulation following = prototype_field(law, 8.0f);
			simulated.set_wind(following.wind());
			const float usual = most_change(simulated, turn);
			const float followed = most_change(following, turn);
			CAPTURE(usual);
			CAPTURE(followed);
			CHECK(followed < MORE * usual);
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

TEST_CASE("only prototypes are stepped, whatever number of plants follows them") {
	FieldSettings settings;
	settings.prototypes = 16;
	FieldSimulation field = mixed_field(settings, 200);
	field.step();
	CHECK(field.simulated_count() == 32);
	CHECK(field.due_count() == 32);
	CHECK(field.plant_count() == 400);
	CHECK(field.state(0, 5).direction.y < 1.0f);
}

TEST_CASE("each step of the history goes on from where the step before ended") {
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
				REQUIRE(models.history()[2 * (slot * Prototypes::MOST + k)] ==
						models.history()[2 * (last * Prototypes::MOST + k) + 1]);
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

TEST_CASE("plants in a row along either axis follow different prototypes, each with a delay of its own") {
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
		CHECK(*delays.rbegin() < 60); // A second.
	}
}

TEST_CASE("prototypes of a species that changes become what its plants are, and go on with their motion") {
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
	field.set_rests(0, rests.data());
	for (int i = 0; i < 50; i++) {
		plant.root.z = static_cast<float>(i);
		plant.rest = rests[static_cast<size_t>(i)];
		const int added = field.add_page(0, &plant, 1);
		for (const glm::vec3 shown : { field.state(added, 0).direction, field.state(0, i).direction }) {
			CHECK(shown.x * plant.rest.x + shown.z * plant.rest.z > 0.75f * std::sin(0.4f) * std::sin(0.4f));
		}
	}
}

TEST_CASE("a gust that is let go goes through plants that follow prototypes, from the upwind edge on") {
	for (const float direction : { 0.0f, 2.2f }) {
		FieldSimulation field = prototype_field(Law::spring, 10.0f);
		FieldWind wind = field.wind();
		wind.wind.kind = WindKind::gust;
		wind.wind.direction = direction;
		wind.wind.strength = 5.0f;
		wind.wind.gust_duration = 1.0f;
		wind.wind.gust_start = -1e6;
		field.set_wind(wind);
		for (int i = 0; i < 10; i++) {
			field.step();
		}
		wind.wind.gust_start = field.time();
		field.set_wind(wind);
		std::vector<float> felt(PLANTS, -1.0f); // When (s).
		for (int i = 0; i < 1200; i++) {
			field.step();
			for (int k = 0; k < PLANTS; k++) {
				if (felt[static_cast<size_t>(k)] < 0.0f && field.state(0, k).direction.y < 0.99f) {
					felt[static_cast<size_t>(k)] = static_cast<float>(i) * FIELD_STEP;
				}
			}
		}
		for (int k = 0; k < PLANTS; k++) {
			const glm::vec3 root = field.page(0).root(k);
			const float way = field.prototype_lead() + wind_delay(wind, root.x, root.z);
			const float own = static_cast<float>(field.follower(0, k).own_delay) * FIELD_STEP;
			REQUIRE(felt[static_cast<size_t>(k)] > way + own);
			REQUIRE(felt[static_cast<size_t>(k)] < way + own + 0.5f);
		}
	}
}

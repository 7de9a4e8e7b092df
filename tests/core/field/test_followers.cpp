#include "prototype_fixture.hpp"
#include "stem/stem_beam.hpp"

#include <doctest/doctest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace undergrowth;

namespace {

constexpr float SAME = 1e-3f; // Rounding by half floats and by the mix of stereographic images.
constexpr float CLOSE = 0.01f;

/// Largest change of any plant's direction in one step, in the ten seconds after waves of wind turn or slow down.
float max_change(FieldSimulation &field, float turn) {
	float max = 0.0f;
	std::vector<glm::vec3> before(FOLLOWERS);
	for (int i = 0; i < 1600; i++) {
		if (i == 1000) {
			FieldWind changed = field.wind();
			changed.wind.direction += turn;
			changed.speed = turn == 0.0f ? 5.0f : changed.speed;
			field.set_wind(changed);
		}
		field.step();
		for (int k = 0; k < FOLLOWERS; k++) {
			const glm::vec3 now = field.state(0, k).direction;
			max = i > 900 ? std::max(max, glm::distance(now, before[static_cast<size_t>(k)])) : 0.0f;
			before[static_cast<size_t>(k)] = now;
		}
	}
	return max;
}

} // namespace

TEST_CASE("followers show the motion of their prototype after the wind's travel time and their own delay") {
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
		float max_delay = 0.0f;
		for (int i = 0; i < FOLLOWERS; i++) {
			const Follower &follower = field.follower(0, i);
			const glm::vec3 root = field.page(0).root(i);
			const float way = (field.prototype_lead() + wind_delay(field.wind(), root.x, root.z)) / FIELD_STEP;
			const float late = std::min(way, 896.0f) + static_cast<float>(follower.own_delay);
			REQUIRE(way > -0.01f);
			max_delay = std::max(max_delay, late);
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
		CHECK((speed > 0.0f || max_delay < 65.0f));
		CHECK((speed != 4.0f || max_delay > 900.0f));
	}
}

TEST_CASE("a follower of a prototype of its own length moves like a simulated plant, after its own delay") {
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
					REQUIRE(glm::distance(following.state(0, k).direction, did[then][static_cast<size_t>(k)]) < CLOSE);
				}
			}
		}
	}
}

TEST_CASE("drawn followers are continuous from step to step") {
	FieldSimulation field = prototype_field(Law::spring, 8.0f);
	field.step();
	for (int i = 0; i < 200; i++) {
		if (i == 100) {
			FieldWind turned = field.wind();
			turned.wind.direction += 1.5f;
			field.set_wind(turned);
		}
		std::vector<glm::vec3> ends;
		for (int k = 0; k < FOLLOWERS; k++) {
			ends.push_back(field.shown_direction(0, k, 1.0f));
		}
		field.step();
		for (int k = 0; k < FOLLOWERS; k++) {
			REQUIRE(glm::distance(field.shown_direction(0, k, 0.0f), ends[static_cast<size_t>(k)]) < 1e-4f);
			const glm::vec3 way = field.shown_direction(0, k, 1.0f) - field.shown_direction(0, k, 0.0f);
			REQUIRE(glm::distance(field.state(0, k).rate, way / FIELD_STEP) <
					0.05f * glm::length(way / FIELD_STEP) + 1e-3f);
		}
	}
}

TEST_CASE("a wind that turns or slows down moves followers per step no more than simulated plants") {
	constexpr float MORE = 2.0f;
	for (const Law law : { Law::elasticity, Law::spring }) {
		for (const float turn : { 0.5f * 3.14159f, 0.0f }) {
			FieldSimulation simulated((FieldSettings()));
			add_plants(simulated, simulated.add_species(species_of(law)), FOLLOWERS);
			FieldSimulation following = prototype_field(law, 8.0f);
			simulated.set_wind(following.wind());
			const float usual = max_change(simulated, turn);
			const float followed = max_change(following, turn);
			CAPTURE(usual);
			CAPTURE(followed);
			CHECK(followed < MORE * usual);
		}
	}
}

TEST_CASE("a triggered gust passes through followers from the upwind edge on") {
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
		std::vector<float> felt(FOLLOWERS, -1.0f); // Time (s).
		for (int i = 0; i < 1200; i++) {
			field.step();
			for (int k = 0; k < FOLLOWERS; k++) {
				if (felt[static_cast<size_t>(k)] < 0.0f && field.state(0, k).direction.y < 0.99f) {
					felt[static_cast<size_t>(k)] = static_cast<float>(i) * FIELD_STEP;
				}
			}
		}
		for (int k = 0; k < FOLLOWERS; k++) {
			const glm::vec3 root = field.page(0).root(k);
			const float way = field.prototype_lead() + wind_delay(wind, root.x, root.z);
			const float own = static_cast<float>(field.follower(0, k).own_delay) * FIELD_STEP;
			REQUIRE(felt[static_cast<size_t>(k)] > way + own);
			REQUIRE(felt[static_cast<size_t>(k)] < way + own + 0.5f);
		}
	}
}

TEST_CASE("stems with a frequency by height follow prototypes of about their height") {
	StemBeam beam;
	beam.natural_frequency = 0.0f;
	MotionSpecies species;
	species.law = Law::stem;
	species.stem = solve_stem(beam).constants;
	species.shortest = 0.7f * beam.length;
	species.longest = 1.3f * beam.length;
	const Prototypes models(0, species, 64, FIELD_STEP);
	std::vector<int> picked;
	for (const float length : { 0.7f, 1.0f, 1.3f }) {
		MotionPlant plant;
		plant.length = length * beam.length;
		for (uint64_t chance = 0; chance < 50; chance++) {
			const int number = models.pick(plant, chance).prototype;
			CHECK(models.length(number) == doctest::Approx(plant.length).epsilon(0.1));
			picked.push_back(number);
		}
	}
	std::sort(picked.begin(), picked.end());
	CHECK(std::unique(picked.begin(), picked.end()) - picked.begin() > 12);
}

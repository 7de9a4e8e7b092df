// Followers of prototypes whose stems have two modes.

#include "../stem/stems.hpp"
#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <vector>

using namespace undergrowth;

namespace {

constexpr float CLOSE = 0.01f; // m, for plants of 0.8 m: rounding by half floats of two modes and of their motion.
constexpr int PLANTS = 20;
constexpr float PLACES[] = { 0.3f, 0.6f, 1.0f };

MotionSpecies reed(int modes) {
	MotionSpecies species;
	species.law = Law::stem;
	species.stem = jointed(4, 0.3, 0.5, modes);
	species.stem.dead_slope = 0.3f;
	species.shortest = species.longest = 0.8f;
	return species;
}

std::vector<MotionPlant> some_reeds() {
	std::vector<MotionPlant> plants;
	for (int i = 0; i < PLANTS; i++) {
		plants.push_back({ chance_plant(i).root, 0.8f, { 0.0f, 1.0f, 0.0f } });
	}
	return plants;
}

FieldSimulation field_of(int prototypes, int modes = 2) {
	FieldSettings settings;
	settings.prototypes = prototypes;
	FieldSimulation field(settings);
	const std::vector<MotionPlant> plants = some_reeds();
	field.add_page(field.add_species(reed(modes)), plants.data(), PLANTS);
	FieldWind wind = wave_wind();
	wind.speed = 15.0f;
	field.set_wind(wind);
	return field;
}

std::vector<glm::vec3> places_of(const FieldSimulation &field, float fraction) {
	std::vector<glm::vec3> places;
	for (int i = 0; i < PLANTS; i++) {
		for (const float share : PLACES) {
			places.push_back(field.shown_point(0, i, share, fraction));
		}
	}
	return places;
}

float max_apart(const std::vector<glm::vec3> &some, const std::vector<glm::vec3> &others) {
	float max = 0.0f;
	for (std::size_t i = 0; i < some.size(); i++) {
		max = std::max(max, glm::distance(some[i], others[i]));
	}
	return max;
}

/// Around the lower half of plant 0.
MovingBody body_at(const FieldSimulation &field) {
	MovingBody body;
	body.from = body.to = field.page(0).root(0) + glm::vec3(0.05f, 0.3f, 0.0f);
	body.radius = 0.2f;
	return body;
}

float second_of(const FieldSimulation &field, int plant) {
	return glm::length(field.motion(0, plant).second.bend);
}

} // namespace

TEST_CASE("a follower's stem bends in both modes like a simulated one, after its own delay") {
	FieldSimulation simulated = field_of(0);
	FieldSimulation following = field_of(1);
	simulated.set_page_near(0, true);
	std::vector<std::vector<glm::vec3>> did;
	float max_second = 0.0f;
	for (int i = 0; i < 2400; i++) {
		simulated.step();
		following.step();
		did.push_back(places_of(simulated, 1.0f));
		if (i <= 2000) {
			continue;
		}
		const std::vector<glm::vec3> now = places_of(following, 1.0f);
		for (int k = 0; k < PLANTS; k++) {
			const auto then = static_cast<std::size_t>(i - following.follower(0, k).own_delay);
			for (std::size_t at = 3 * static_cast<std::size_t>(k); at < 3 * static_cast<std::size_t>(k) + 3; at++) {
				REQUIRE(glm::distance(now[at], did[then][at]) < CLOSE);
			}
			max_second = std::max(max_second, second_of(following, k));
		}
	}
	CHECK(following.prototypes(0)->modes() == 2);
	CHECK(max_second > 0.003f);
}

TEST_CASE("a follower with a pushed stem swings in both modes and returns to its prototype without a jump") {
	FieldSimulation field = field_of(64);
	for (int i = 0; i < 300; i++) {
		field.step();
	}
	const MovingBody body = body_at(field);
	float max_second = 0.0f;
	const float calm_second = second_of(field, 0);
	for (int i = 0; i < 400; i++) {
		field.set_bodies(&body, i < 30 ? 1 : 0);
		const std::vector<glm::vec3> before = places_of(field, 1.0f);
		field.step();
		max_second = std::max(max_second, second_of(field, 0));
		if (i == 60) {
			CHECK(field.follower(0, 0).detached > 0);
		}
		if (i > 30) { // Not while the body pushes.
			REQUIRE(max_apart(places_of(field, 0.0f), before) < 3e-3f);
		}
	}
	CHECK(max_second > 5.0f * calm_second);
	CHECK(field.follower(0, 0).detached == 0);
}

TEST_CASE("an impulse on a follower acts on both modes of its stem") {
	FieldSimulation simulated = field_of(0);
	FieldSimulation following = field_of(1);
	FieldWind calm;
	calm.wind.strength = 0.0f;
	for (FieldSimulation *field : { &simulated, &following }) {
		field->set_wind(calm);
		field->step();
		field->apply_impulse(0, 3, { 0.01f, 0.0f, 0.004f });
	}
	float max_second = 0.0f;
	for (int i = 0; i < 90; i++) {
		simulated.step();
		following.step();
		REQUIRE(max_apart(places_of(following, 1.0f), places_of(simulated, 1.0f)) < CLOSE);
		max_second = std::max(max_second, second_of(following, 3));
	}
	CHECK(max_second > 0.01f);
}

TEST_CASE("followers stay in place when their stems gain or lose a second mode") {
	for (const int modes : { 1, 2 }) {
		FieldSimulation field = field_of(8, modes);
		for (int i = 0; i < 400; i++) {
			field.step();
		}
		const std::vector<glm::vec3> before = places_of(field, 1.0f);
		field.set_species(0, reed(3 - modes));
		CHECK(field.prototypes(0)->modes() == 3 - modes);
		CHECK(max_apart(places_of(field, 1.0f), before) < (modes == 1 ? 2e-3f : 0.02f));
		for (int i = 0; i < 100; i++) {
			const std::vector<glm::vec3> last = places_of(field, 1.0f);
			field.step();
			REQUIRE(max_apart(places_of(field, 0.0f), last) < 3e-3f);
		}
	}
}

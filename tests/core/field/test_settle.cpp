#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

using namespace undergrowth;

namespace {

constexpr float REST_TOLERANCE = 1e-6f; // Rounding of a state in another representation.

} // namespace

TEST_CASE("a settled field is at rest and stays at rest in still air") {
	for (const Law law : { Law::elasticity, Law::spring }) {
		FieldSimulation field((FieldSettings()));
		add_plants(field, field.add_species(species_of(law)), 300);
		field.set_wind(wave_wind());
		for (int i = 0; i < 100; i++) {
			field.step();
		}
		field.settle();
		FieldWind calm;
		calm.wind.strength = 0.0f;
		field.set_wind(calm);
		for (int round = 0; round < 2; round++) {
			for (int i = 0; i < 300; i++) {
				const TipState state = field.state(0, i);
				CHECK(glm::distance(state.direction, field.page(0).rest(i)) < REST_TOLERANCE);
				CHECK(glm::length(state.rate) < REST_TOLERANCE);
				CHECK(field.page(0).bends()[2 * i] == field.page(0).bends()[2 * i + 1]);
			}
			field.step();
		}
	}
}

TEST_CASE("followers of prototypes settle, too, and pushed ones follow again") {
	FieldSettings settings;
	settings.prototypes = 8;
	FieldSimulation field(settings);
	add_plants(field, field.add_species(species_of(Law::spring)), 300);
	field.set_wind(wave_wind());
	for (int i = 0; i < 100; i++) {
		field.step();
	}
	field.apply_impulse(0, 7, { 1.0f, 0.0f, 0.0f });
	REQUIRE(field.detached_followers(0)->count() == 1);
	field.settle();
	CHECK(field.detached_followers(0)->count() == 0);
	FieldWind calm;
	calm.wind.strength = 0.0f;
	field.set_wind(calm);
	for (int round = 0; round < 3; round++) {
		for (int i = 0; i < 300; i++) {
			const glm::vec3 rest = field.prototypes(0)->rest(field.follower(0, i).prototype);
			CHECK(glm::distance(field.shown_direction(0, i, 0.5f), rest) < 1e-3f); // One step of half floats.
		}
		field.step();
	}
}

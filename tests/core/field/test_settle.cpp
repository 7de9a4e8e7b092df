#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

using namespace undergrowth;

namespace {

constexpr float REST_TOLERANCE = 1e-6f; // Rounding of a state that is stored in another way.

} // namespace

TEST_CASE("a field that settles is at rest, and stays there in still air") {
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

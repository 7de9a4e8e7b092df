#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <limits>

using namespace undergrowth;

TEST_CASE("a point near a stem or a tip is in plants, one between plants is not") {
	MotionPlant plant;
	plant.root = { 3.0f, 0.0f, -2.0f };
	const FieldSimulation field = single_plant(Law::spring, plant);
	CHECK(field.is_point_in_plants({ 3.04f, 0.5f, -2.0f }, 0.0f));
	CHECK(field.is_point_in_plants({ 3.0f, 1.04f, -2.0f }, 0.0f));
	CHECK_FALSE(field.is_point_in_plants({ 3.1f, 0.5f, -2.0f }, 0.0f));
	CHECK(field.is_point_in_plants({ 3.1f, 0.5f, -2.0f }, 0.06f));
	CHECK_FALSE(field.is_point_in_plants({ 3.0f, 1.2f, -2.0f }, 0.0f));
	CHECK_FALSE(field.is_point_in_plants({ std::numeric_limits<float>::quiet_NaN(), 0.5f, -2.0f }, 0.0f));
}

TEST_CASE("points are tested against drawn plants, not against plants in calm air") {
	for (const int prototypes : { 0, 8 }) {
		FieldSettings settings;
		settings.prototypes = prototypes;
		MotionSpecies species = species_of(Law::spring);
		species.shortest = species.longest = 1.0f;
		species.joint.damping_ratio = 1.0f;
		FieldSimulation field(settings);
		const MotionPlant plant;
		field.add_page(field.add_species(species), &plant, 1);
		field.set_wind({ { WindKind::constant, 8.0f }, 0.0f });
		for (int i = 0; i < 600; i++) {
			field.step();
		}
		const glm::vec3 tip = field.state(0, 0).direction;
		REQUIRE(glm::distance(tip, glm::vec3(0.0f, 1.0f, 0.0f)) > 0.3f);
		CHECK(field.is_point_in_plants(tip, 0.0f));
		CHECK_FALSE(field.is_point_in_plants({ 0.0f, 1.0f, 0.0f }, 0.0f));
	}
	// A plant with rare steps is tested at its current drawn pose, on the way to the end of its long step.
	FieldSimulation seldom = single_plant(Law::spring, {});
	seldom.set_page_multiple(0, 32);
	seldom.apply_impulse(0, 0, { 0.1f, 0.0f, 0.0f });
	seldom.step();
	CHECK(seldom.is_point_in_plants(seldom.shown_direction(0, 0, 1.0f), -0.04f));
}

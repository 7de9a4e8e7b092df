#include "field/contact.hpp"
#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>

using namespace undergrowth;

namespace {

MotionSpecies kind_of(float mass, float radius) {
	MotionSpecies species = species_of(Law::spring);
	species.joint.mass = mass;
	species.collision_radius = radius;
	return species;
}

void add_at(FieldSimulation &field, const MotionSpecies &species, float x) {
	MotionPlant plant;
	plant.root.x = x;
	field.add_page(field.add_species(species), &plant, 1);
}

TipState leaning_at(float x, float rate) {
	return { { x, std::sqrt(1.0f - x * x), 0.0f }, { rate, 0.0f, 0.0f } };
}

TipContact resolved(FieldSimulation &field) {
	TipContact contact;
	contact.fit(field);
	contact.resolve(field);
	return contact;
}

} // namespace

TEST_CASE("of two touching tips the lighter one moves, and momentum is conserved") {
	FieldSimulation field((FieldSettings()));
	add_at(field, kind_of(0.1f, 0.05f), 0.0f);
	add_at(field, kind_of(0.9f, 0.05f), 0.12f);
	field.page(0).set_state(0, leaning_at(0.05f, 1.0f));
	const TipContact contact = resolved(field);
	REQUIRE(contact.contacts(0, 0) == 1);
	const TipState light = field.state(0, 0);
	const TipState heavy = field.state(1, 0);
	CHECK(heavy.rate.x == doctest::Approx(0.1).epsilon(0.02));
	CHECK(light.rate.x == doctest::Approx(0.1).epsilon(0.02));
	CHECK(0.05f - light.direction.x == doctest::Approx(0.027).epsilon(0.03));
	CHECK(heavy.direction.x == doctest::Approx(0.003).epsilon(0.03));
}

TEST_CASE("thick tips touch, also when other species follow theirs") {
	for (const bool thick_first : { true, false }) {
		FieldSimulation field((FieldSettings()));
		if (!thick_first) {
			add_at(field, kind_of(0.4f, 0.01f), 5.0f);
		}
		const int first = field.page_count();
		add_at(field, kind_of(0.4f, 0.2f), 0.0f);
		add_at(field, kind_of(0.4f, 0.2f), 0.42f);
		if (thick_first) {
			add_at(field, kind_of(0.4f, 0.01f), 5.0f);
		}
		field.page(first).set_state(0, leaning_at(0.06f, 0.0f));
		CHECK(resolved(field).contacts(first, 0) == 1);
		CHECK(field.state(first, 0).direction.x < 0.055f);
		CHECK(field.state(first + 1, 0).direction.x > 0.005f);
	}
}

TEST_CASE("tips at exactly one position separate") {
	MotionPlant plants[2];
	plants[0].rest = glm::normalize(glm::vec3(0.2f, 1.0f, 0.0f));
	plants[1].rest = glm::normalize(glm::vec3(-0.2f, 1.0f, 0.0f));
	FieldSimulation field((FieldSettings()));
	field.add_page(field.add_species(kind_of(0.4f, 0.05f)), plants, 2);
	field.page(0).set_state(0, {});
	field.page(0).set_state(1, {});
	REQUIRE(field.page(0).tip(0) == field.page(0).tip(1));
	REQUIRE(resolved(field).contacts(0, 0) == 1);
	CHECK(field.state(0, 0).direction.x > 0.02f);
	CHECK(field.state(0, 1).direction.x < -0.02f);
}

TEST_CASE("contact removes the approach of tips in metres, for any length of plants") {
	for (const float length : { 0.5f, 2.0f }) {
		MotionPlant plants[2];
		plants[0].length = plants[1].length = length;
		plants[1].root.x = 0.12f;
		FieldSimulation field((FieldSettings()));
		field.add_page(field.add_species(kind_of(0.4f, 0.05f)), plants, 2);
		field.page(0).set_state(0, leaning_at(0.05f / length, 1.0f));
		REQUIRE(resolved(field).contacts(0, 0) == 1);
		CHECK(field.state(0, 0).rate.x == doctest::Approx(0.5).epsilon(0.05));
		CHECK(field.state(0, 1).rate.x == doctest::Approx(0.5).epsilon(0.05));
		const float apart = field.page(0).tip(1).x - field.page(0).tip(0).x;
		CHECK(apart == doctest::Approx(0.1).epsilon(0.05));
	}
}

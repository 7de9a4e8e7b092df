#include "../stem/stems.hpp"
#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <functional>

using namespace undergrowth;

namespace {

constexpr Law BOTH_LAWS[] = { Law::elasticity, Law::spring };

struct Change {
	Law law;
	std::function<void(MotionSpecies &)> make;
};

/// Each property of a species that changes the motion of its plants.
std::vector<Change> changes() {
	return {
		{ Law::elasticity, [](MotionSpecies &kind) { kind.joint.mass *= 2.0f; } },
		{ Law::elasticity, [](MotionSpecies &kind) { kind.joint.wind_weight *= 0.5f; } },
		{ Law::elasticity, [](MotionSpecies &kind) { kind.joint.elasticity *= 1.5f; } },
		{ Law::elasticity, [](MotionSpecies &kind) { kind.joint.inner_friction *= 3.0f; } },
		{ Law::spring, [](MotionSpecies &kind) { kind.joint.mass *= 2.0f; } },
		{ Law::spring, [](MotionSpecies &kind) { kind.joint.wind_weight *= 0.5f; } },
		{ Law::spring, [](MotionSpecies &kind) { kind.joint.natural_frequency *= 1.5f; } },
		{ Law::spring, [](MotionSpecies &kind) { kind.joint.damping_ratio *= 3.0f; } },
	};
}

FieldSimulation windy_field(const MotionSpecies &species, int prototypes) {
	FieldSettings settings;
	settings.prototypes = prototypes;
	FieldSimulation field(settings);
	add_plants(field, field.add_species(species), 40);
	field.set_wind(wave_wind());
	return field;
}

void step(FieldSimulation &field, int steps) {
	for (int i = 0; i < steps; i++) {
		field.step();
	}
}

} // namespace

TEST_CASE("plants of a changed species move like plants that always had the new properties") {
	for (const int prototypes : { 0, 8 }) {
		for (const Change &change : changes()) {
			const MotionSpecies before = species_of(change.law);
			MotionSpecies after = before;
			change.make(after);
			FieldSimulation changed = windy_field(before, prototypes);
			changed.set_species(0, after);
			FieldSimulation always = windy_field(after, prototypes);
			FieldSimulation never = windy_field(before, prototypes);
			step(changed, 200);
			step(always, 200);
			step(never, 200);
			CHECK(hash_field(changed) == hash_field(always));
			CHECK(hash_field(changed) != hash_field(never));
		}
	}
}

TEST_CASE("a change of a species preserves positions and velocities of plants, and changes their bends afterwards") {
	for (const Change &change : changes()) {
		FieldSimulation field = windy_field(species_of(change.law), 0);
		step(field, 45);
		MotionSpecies after = species_of(change.law);
		change.make(after);
		const TipState before = field.state(0, 7);
		REQUIRE(glm::length(before.rate) > 0.01f);
		field.set_species(0, after);
		CHECK(glm::distance(field.state(0, 7).direction, before.direction) < 1e-6f);
		CHECK(glm::distance(field.state(0, 7).rate, before.rate) < 1e-5f);
	}
}

TEST_CASE("a pushed follower swings by the current properties of its species") {
	for (const Change &change : changes()) {
		MotionSpecies after = species_of(change.law);
		change.make(after);
		FieldSimulation changed = windy_field(species_of(change.law), 8);
		FieldSimulation never = windy_field(species_of(change.law), 8);
		for (FieldSimulation *field : { &changed, &never }) {
			step(*field, 30);
			field->apply_impulse(0, 3, { 0.2f, 0.0f, 0.1f });
		}
		changed.set_species(0, after);
		const DetachedFollowers &detached = *changed.detached_followers(0);
		REQUIRE(detached.count() == 1);
		step(changed, 20);
		step(never, 20);
		CHECK(glm::distance(changed.state(0, 3).direction, never.state(0, 3).direction) > 1e-4f);
	}
}

TEST_CASE("moving plants of a species with a changed law continue and come to rest upright") {
	for (const Law law : BOTH_LAWS) {
		const Law other = law == Law::elasticity ? Law::spring : Law::elasticity;
		MotionPlant plant;
		FieldSimulation field = single_plant(law, plant);
		field.set_wind({ { WindKind::constant, 0.0f }, 0.0f });
		field.apply_impulse(0, 0, { 0.4f, 0.0f, 0.25f });
		step(field, 8);
		const TipState before = field.state(0, 0);
		REQUIRE(glm::length(before.rate) > 0.2f);
		field.set_species(0, species_of(other));
		CHECK(glm::distance(field.state(0, 0).direction, before.direction) < 1e-5f);
		CHECK(glm::distance(field.state(0, 0).rate, before.rate) < 1e-4f);
		step(field, 4000);
		CHECK(glm::distance(field.state(0, 0).direction, glm::vec3(0.0f, 1.0f, 0.0f)) < 1e-3f);
	}
}

TEST_CASE("moving stems continue when their number of modes changes") {
	for (const int modes : { 1, 2 }) {
		MotionSpecies before = species_of(Law::stem), after = before;
		before.stem = jointed(4, 0.3, 0.5, modes);
		after.stem = jointed(4, 0.3, 0.5, 3 - modes);
		FieldSimulation field(FieldSettings{});
		add_plants(field, field.add_species(before), 40);
		field.set_wind(wave_wind());
		field.set_page_near(0, true); // All modes are stepped.
		step(field, 120);
		const TipState was = field.state(0, 3);
		REQUIRE(glm::length(was.rate) > 0.1f);
		field.set_species(0, after);
		CHECK(glm::distance(field.state(0, 3).direction, was.direction) < 1e-4f);
		CHECK(glm::distance(field.state(0, 3).rate, was.rate) < 1e-3f * glm::length(was.rate));
		step(field, 1);
		CHECK(glm::distance(field.state(0, 3).direction, was.direction) < 0.2f);
	}
}

TEST_CASE("plants lean again when a law with rest directions returns") {
	MotionPlant plant;
	plant.rest = glm::normalize(glm::vec3(0.3f, 1.0f, 0.1f));
	FieldSimulation field = single_plant(Law::spring, plant);
	field.set_wind({ { WindKind::constant, 0.0f }, 0.0f });
	field.set_species(0, species_of(Law::elasticity));
	field.set_species(0, species_of(Law::spring));
	field.set_rests(0, 0, &plant.rest, 1);
	step(field, 2000);
	CHECK(glm::distance(field.state(0, 0).direction, plant.rest) < 1e-3f);
}

TEST_CASE("a change of the step length preserves position and velocity of a plant") {
	for (const Law law : BOTH_LAWS) {
		FieldSimulation field = single_plant(law, {});
		field.set_wind({ { WindKind::constant, 0.0f }, 0.0f });
		field.apply_impulse(0, 0, { 0.3f, 0.0f, 0.0f });
		step(field, 5);
		const TipState before = field.state(0, 0);
		REQUIRE(glm::length(before.rate) > 0.2f);
		for (const float length : { 4.0f * FIELD_STEP, 0.5f * FIELD_STEP, FIELD_STEP }) {
			field.page(0).set_step_length(length);
			CHECK(field.page(0).step_length() == length);
			CHECK(glm::distance(field.state(0, 0).direction, before.direction) < 1e-6f);
			CHECK(glm::distance(field.state(0, 0).rate, before.rate) < 1e-5f);
		}
	}
}

TEST_CASE("a plant at another update interval swings at the same frequency") {
	for (const Law law : BOTH_LAWS) {
		FieldSimulation often = single_plant(law, {});
		FieldSimulation seldom = single_plant(law, {});
		for (FieldSimulation *field : { &often, &seldom }) {
			field->set_wind({ { WindKind::constant, 0.0f }, 0.0f });
			field->apply_impulse(0, 0, { 0.02f, 0.0f, 0.0f });
			step(*field, 30);
		}
		seldom.set_page_multiple(0, 4);
		// Step 32 is the first of interval 4, and its result is that of step 35. A step of the elasticity law begins
		// with the rate of the middle of the last one, which was shorter.
		step(often, 6);
		step(seldom, 3);
		for (int i = 0; i < 100; i++) {
			CHECK(glm::distance(often.state(0, 0).direction, seldom.state(0, 0).direction) < 3e-3f);
			step(often, 4);
			step(seldom, 4);
		}
	}
}

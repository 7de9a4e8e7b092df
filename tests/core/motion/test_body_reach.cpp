#include "../field/field_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>

using namespace undergrowth;

namespace {

constexpr Law BOTH_LAWS[] = { Law::elasticity, Law::spring };

MovingBody ball(const glm::vec3 &place, float radius) {
	MovingBody body;
	body.from = body.to = place;
	body.radius = radius;
	return body;
}

} // namespace

TEST_CASE("a ball at the upper stem pushes the plant, though it is far below the tip") {
	for (const Law law : BOTH_LAWS) {
		FieldSimulation field = single_plant(law, {});
		const MovingBody low = ball({ -0.08f, 0.6f, 0.0f }, 0.1f);
		field.set_bodies(&low, 1);
		field.step();
		CHECK(field.state(0, 0).direction.x > 0.02f);
		CHECK(field.state(0, 0).direction.x < 0.06f);
	}
}

TEST_CASE("a ball pushes a tip from every side within its collision sphere, and from no farther") {
	constexpr float RADIUS = 0.1f;
	constexpr float THICK = 0.3f;
	for (const glm::vec3 lean : { glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 0, 1), glm::vec3(0, 0, -1) }) {
		for (const float apart : { RADIUS + THICK - 0.01f, RADIUS + THICK + 0.01f }) {
			MotionSpecies species = species_of(Law::spring);
			species.collision_radius = THICK;
			FieldSimulation field((FieldSettings()));
			const MotionPlant plant;
			field.add_page(field.add_species(species), &plant, 1);
			MotionPage &page = field.page(0);
			page.set_state(0, { glm::normalize(lean + glm::vec3(0.0f, 0.1f, 0.0f)), {} });
			const glm::vec3 way = page.state(0).direction;
			MovingBody body = ball(page.tip(0) + apart * way, RADIUS);
			// Slightly aside, so that there is a direction to turn.
			body.from += 0.002f * glm::vec3(way.z, 0.0f, -way.x);
			body.to = body.from;
			body.velocity = 0.5f * glm::vec3(-way.z, 0.0f, way.x);
			const glm::vec3 before = page.tip(0);
			field.set_bodies(&body, 1);
			int visited = 0;
			for_each_in_reach(page, body, [&](int) { visited++; });
			TipState state = page.state(0);
			const bool touched = push_plant(state, page.root(0), page.length(0), THICK, body);
			CHECK(touched == (apart < RADIUS + THICK));
			CHECK((visited == 1 || !touched));
			CHECK((glm::distance(page.root(0) + page.length(0) * state.direction, before) > 1e-4f) == touched);
		}
	}
}

TEST_CASE("a ball stops and moves an approaching tip in metres per second, for any length of the plant") {
	for (const Law law : BOTH_LAWS) {
		for (const float length : { 0.5f, 2.0f }) {
			MotionPlant plant;
			plant.length = length;
			FieldSimulation field = single_plant(law, plant);
			MovingBody body = ball({ -0.25f, length, 0.0f }, 0.25f);
			field.page(0).set_state(0, { { 0.0f, 1.0f, 0.0f }, { -1.0f, 0.0f, 0.5f } });
			push_plants(field.page(0), body);
			CHECK(std::fabs(field.state(0, 0).rate.x) < 0.05f);
			CHECK(field.state(0, 0).rate.z == doctest::Approx(0.5).epsilon(0.05));
			body.velocity.x = 1.0f;
			push_plants(field.page(0), body);
			CHECK(field.state(0, 0).rate.x * length == doctest::Approx(1.0).epsilon(0.05));
		}
	}
}

TEST_CASE("an impulse gives a tip its impulse over its mass, for any length of the plant") {
	for (const Law law : BOTH_LAWS) {
		for (const int prototypes : { 0, 4 }) {
			for (const float length : { 0.5f, 2.0f }) {
				MotionPlant plant;
				plant.length = length;
				FieldSettings settings;
				settings.prototypes = prototypes;
				FieldSimulation field = single_plant(law, plant, settings);
				field.set_wind({ { WindKind::constant, 0.0f }, 0.0f });
				field.step();
				field.apply_impulse(0, 0, { 0.2f, 0.0f, -0.1f });
				CHECK(field.state(0, 0).rate.x * length == doctest::Approx(0.2 / 0.4).epsilon(0.01));
				CHECK(field.state(0, 0).rate.z * length == doctest::Approx(-0.1 / 0.4).epsilon(0.01));
			}
		}
	}
}

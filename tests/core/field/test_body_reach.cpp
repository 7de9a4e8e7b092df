#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>

using namespace undergrowth;

namespace {

constexpr Law BOTH_LAWS[] = { Law::elasticity, Law::spring };

FieldBody ball(const glm::vec3 &place, float radius) {
	FieldBody body;
	body.from = body.to = place;
	body.radius = radius;
	return body;
}

} // namespace

TEST_CASE("a ball at the upper stem pushes the plant, though it is far below the tip") {
	for (const Law law : BOTH_LAWS) {
		FieldSimulation field = single_plant(law, {});
		const FieldBody low = ball({ -0.08f, 0.6f, 0.0f }, 0.1f);
		field.set_bodies(&low, 1);
		field.step();
		CHECK(field.state(0, 0).direction.x > 0.02f);
		CHECK(field.state(0, 0).direction.x < 0.06f);
	}
}

TEST_CASE("a ball pushes a tip from every side that its collision sphere reaches, and from no farther") {
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
			FieldBody body = ball(page.tip(0) + apart * way, RADIUS);
			// Aside a little, so that there is a way to turn.
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

#include "../field/field_fixture.hpp"
#include "../stem/stems.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

using namespace undergrowth;

namespace {

constexpr Law BOTH_LAWS[] = { Law::elasticity, Law::spring };
constexpr float CLEAR_TOLERANCE = 0.02f; // m, between a tip and a body that pushes it out once per step.

MovingBody walker(float x) {
	MovingBody body;
	body.from = { x, 0.4f, 0.0f };
	body.to = { x, 1.4f, 0.0f };
	body.radius = 0.4f;
	body.velocity = { 1.0f, 0.0f, 0.0f };
	return body;
}

FieldSimulation calm_plant(Law law) {
	MotionPlant plant;
	plant.root.z = 0.1f;
	FieldSimulation field = single_plant(law, plant);
	field.set_wind({ { WindKind::constant, 0.0f }, 0.0f });
	return field;
}

} // namespace

TEST_CASE("a tip stays outside of a capsule that moves into it, and swings out afterwards") {
	for (const Law law : BOTH_LAWS) {
		FieldSimulation field = calm_plant(law);
		float max = 0.0f;
		for (int i = 0; i < 90; i++) {
			const MovingBody body = walker(-1.5f + static_cast<float>(i) * FIELD_STEP);
			field.set_bodies(&body, 1);
			field.step();
			const glm::vec3 tip = field.page(0).tip(0);
			const float apart = glm::distance(tip, nearest_on_segment(body.from, body.to, tip));
			CHECK(apart > body.radius + field.page(0).collision_radius() - CLEAR_TOLERANCE);
			max = std::max(max, field.state(0, 0).direction.x);
		}
		CHECK(max > 0.2f);
		field.set_bodies(nullptr, 0);
		int crossings = 0;
		float before = field.state(0, 0).direction.x;
		for (int i = 0; i < 3000; i++) {
			field.step();
			const float now = field.state(0, 0).direction.x;
			crossings += (now < 0.0f) != (before < 0.0f) ? 1 : 0;
			before = now;
		}
		CHECK(crossings >= 3);
		CHECK(std::fabs(field.state(0, 0).direction.x) < 1e-3f);
		CHECK(glm::length(field.state(0, 0).rate) < 1e-3f);
	}
}

TEST_CASE("a sphere pushes with its velocity, and a body at rest only stops approaching tips") {
	for (const Law law : BOTH_LAWS) {
		FieldSimulation field = calm_plant(law);
		MovingBody ball;
		ball.from = ball.to = { -0.3f, 1.0f, 0.1f };
		ball.radius = 0.3f;
		ball.velocity = { 2.0f, 0.0f, 0.0f };
		push_plants(field.page(0), ball);
		CHECK(field.state(0, 0).rate.x == doctest::Approx(2.0).epsilon(0.02));

		FieldSimulation other = calm_plant(law);
		other.apply_impulse(0, 0, { -0.4f, 0.0f, 0.0f });
		ball.velocity = {};
		CHECK(push_plants(other.page(0), ball) == 1);
		CHECK(std::fabs(other.state(0, 0).rate.x) < 0.05f);
	}
}

TEST_CASE("a growing sphere pushes with the velocity of its surface, and a shrinking one does not hold tips") {
	for (const Law law : BOTH_LAWS) {
		FieldSimulation field = calm_plant(law);
		MovingBody ball;
		ball.from = ball.to = { -0.3f, 1.0f, 0.1f };
		ball.radius = 0.3f;
		ball.growth = 2.0f;
		push_plants(field.page(0), ball);
		CHECK(field.page(0).tip_velocity(0).x == doctest::Approx(2.0).epsilon(0.02));

		FieldSimulation other = calm_plant(law);
		ball.growth = -2.0f;
		CHECK(push_plants(other.page(0), ball) == 1);
		CHECK(std::fabs(other.page(0).tip_velocity(0).x) < 0.05f);
	}
}

TEST_CASE("a stem beside a growing sphere moves with its surface") {
	StemState still, pushed;
	MovingBody ball;
	ball.from = ball.to = { -0.3f, 0.5f, 0.0f };
	ball.radius = 0.31f;
	const StemConstants stem = solve_stem(stem_of(0.3)).constants;
	const auto speed_of = [&](StemState &state, float growth) {
		ball.growth = growth;
		REQUIRE(push_plant(stem, state, { 0.0f, 0.0f }, { 0.0f, 0.0f, 0.0f }, stem.length, 0.0f, ball));
		return state.rate[0].x;
	};
	CHECK(speed_of(still, 0.0f) == doctest::Approx(0.0));
	CHECK(speed_of(pushed, 2.0f) > 1.0f);
}

TEST_CASE("distant bodies, bodies below another page's plants and invalid ones touch nothing") {
	FieldSimulation field = calm_plant(Law::spring);
	const uint64_t before = hash_field(field);
	MovingBody body = walker(30.0f);
	CHECK(push_plants(field.page(0), body) == 0);
	body = walker(0.0f);
	body.from.x = std::numeric_limits<float>::quiet_NaN();
	CHECK(push_plants(field.page(0), body) == 0);
	body = walker(0.0f);
	body.radius = 0.0f;
	CHECK(push_plants(field.page(0), body) == 0);
	CHECK(hash_field(field) == before);
}

TEST_CASE("a body on top of a stem, or with its axis in the tip, separates from it without an invalid number") {
	for (const Law law : BOTH_LAWS) {
		for (const float height : { 0.6f, 1.0f, 1.3f }) {
			FieldSimulation field = calm_plant(law);
			MovingBody ball;
			ball.from = ball.to = { 0.0f, height, 0.1f };
			ball.radius = 0.5f;
			for (int i = 0; i < 60; i++) {
				field.set_bodies(&ball, 1);
				field.step();
			}
			CHECK(std::isfinite(field.state(0, 0).direction.x + field.state(0, 0).rate.x));
			CHECK(field.state(0, 0).direction.y > 0.0f);
		}
	}
}

namespace {

/// A crate of 2 x 1 x 0.6 m turned about the vertical, with edges rounded by 2 cm.
MovingBody crate(const glm::vec3 &middle, float turn) {
	const glm::vec3 along = { std::cos(turn), 0.0f, -std::sin(turn) };
	const glm::vec3 across = { std::sin(turn), 0.0f, std::cos(turn) };
	MovingBody body;
	body.radius = 0.02f;
	body.from = middle - 0.98f * along;
	body.to = middle + 0.98f * along;
	body.half_width = { 0.0f, 0.48f, 0.0f };
	body.half_depth = 0.28f * across;
	return body;
}

/// m, distance of a point from the crate's faces; below 0 inside.
float crate_distance(const glm::vec3 &middle, float turn, const glm::vec3 &point) {
	const glm::vec3 offset = point - middle;
	const float along = std::fabs(std::cos(turn) * offset.x - std::sin(turn) * offset.z) - 1.0f;
	const float across = std::fabs(std::sin(turn) * offset.x + std::cos(turn) * offset.z) - 0.3f;
	return std::max(std::max(along, across), std::fabs(offset.y) - 0.5f);
}

} // namespace

TEST_CASE("a tip deep in a crate exits by the nearest side, on either side of its centre") {
	for (const Law law : BOTH_LAWS) {
		for (const float side : { 0.1f, -0.1f }) {
			for (const bool is_turned : { false, true }) {
				FieldSimulation field = calm_plant(law);
				const glm::vec3 middle = is_turned ? glm::vec3(-side, 0.9f, 0.1f) : glm::vec3(0.0f, 0.9f, 0.1f - side);
				const MovingBody body = crate(middle, is_turned ? 1.5707964f : 0.0f);
				field.set_bodies(&body, 1);
				field.step();
				const glm::vec3 direction = field.state(0, 0).direction;
				CHECK((is_turned ? direction.x : direction.z) * side > 0.01f);
				CHECK(std::fabs(is_turned ? direction.z : direction.x) < 0.01f);
			}
		}
	}
}

TEST_CASE("tips stay outside of a moving crate, up to its corners") {
	for (const Law law : BOTH_LAWS) {
		for (const float turn : { 0.0f, 0.5f, 1.5707964f }) {
			FieldSimulation field((FieldSettings()));
			std::vector<MotionPlant> plants(41);
			for (int i = 0; i < 41; i++) {
				plants[static_cast<size_t>(i)].root.z = 0.05f * static_cast<float>(i - 20);
				plants[static_cast<size_t>(i)].root.x = 0.003f * static_cast<float>(i);
			}
			MotionSpecies species = species_of(law);
			species.collision_radius = 0.0f;
			field.add_page(field.add_species(species), plants.data(), 41);
			field.set_wind({ { WindKind::constant, 0.0f }, 0.0f });
			float deepest = 0.0f;
			int leaning = 0;
			for (int i = 0; i < 150; i++) {
				const glm::vec3 middle = { -2.0f + 1.5f * static_cast<float>(i) * FIELD_STEP, 1.1f, 0.0f };
				MovingBody body = crate(middle, turn);
				body.velocity.x = 1.5f;
				field.set_bodies(&body, 1);
				field.step();
				for (int plant = 0; plant < 41; plant++) {
					deepest = std::min(deepest, crate_distance(middle, turn, field.page(0).tip(plant)));
					leaning += field.state(0, plant).direction.x > 0.3f ? 1 : 0;
				}
			}
			CAPTURE(turn);
			CHECK(deepest > -0.05f);
			CHECK(leaning > 100);
		}
	}
}

TEST_CASE("a tip at the centre of a crate exits by its side, not by its length") {
	for (const Law law : BOTH_LAWS) {
		FieldSimulation field = calm_plant(law);
		const MovingBody body = crate({ 0.3f, 1.0f, 0.0f }, 0.0f);
		for (int i = 0; i < 30; i++) {
			field.set_bodies(&body, 1);
			field.step();
		}
		CHECK(field.page(0).tip(0).z > 0.28f);
		CHECK(std::fabs(field.page(0).tip(0).x) < 0.05f);
	}
}

TEST_CASE("a tip in the core of a rounded box also exits beyond its rounded edges") {
	MovingBody body; // 0.1 m and 0.2 m to each side of its centre line, rounded by 0.1 m.
	body.from = { 0.05f, 0.9f, -1.0f };
	body.to = { 0.05f, 0.9f, 1.0f };
	body.half_width = { 0.1f, 0.0f, 0.0f };
	body.half_depth = { 0.0f, 0.2f, 0.0f };
	body.radius = 0.1f;
	TipState state;
	CHECK(push_plant(state, glm::vec3(0.0f), 1.0f, 0.0f, body));
	CHECK(state.direction.x < -0.14f); // The nearest side is at -0.15 m.
}

TEST_CASE("no body pushes a tip into the ground") {
	MovingBody body; // Comes down on a leaning plant.
	body.from = body.to = { 0.4f, 1.2f, 0.0f };
	body.radius = 1.4f;
	TipState state;
	state.direction = glm::normalize(glm::vec3(0.9f, 0.3f, 0.0f));
	for (int i = 0; i < 20; i++) {
		push_plant(state, glm::vec3(0.0f), 1.0f, 0.0f, body);
		CHECK(state.direction.y > 0.5f * MIN_PUSHED_HEIGHT);
	}
	CHECK(state.direction.y < 0.1f); // The pushes moved it down to there.
}

TEST_CASE("a crate does not push plants that it only passes") {
	FieldSimulation field = calm_plant(Law::elasticity);
	CHECK(push_plants(field.page(0), crate({ 0.0f, 1.0f, 0.48f }, 0.0f)) == 0);
	CHECK(push_plants(field.page(0), crate({ 0.0f, 1.0f, 0.4f }, 0.0f)) == 1);
	CHECK(push_plants(field.page(0), crate({ 1.1f, 1.0f, 0.1f }, 0.0f)) == 0);
}

TEST_CASE("a body touches a plant from its root to its tip, within the margin") {
	FieldSimulation field = calm_plant(Law::elasticity);
	MovingBody ball;
	ball.radius = 0.1f;
	for (const float height : { 0.0f, 0.25f, 0.5f, 0.75f }) {
		ball.from = ball.to = { 0.25f, height, 0.1f };
		CHECK(!touches_plants(field.page(0), ball, 0.14f));
		CHECK(touches_plants(field.page(0), ball, 0.16f));
	}
	ball.from = ball.to = { 0.25f, 1.0f, 0.1f };
	CHECK(touches_plants(field.page(0), ball, 0.11f)); // The tip is a sphere.
	ball.from = { -3.0f, 0.5f, 0.2f };
	ball.to = { 3.0f, 0.5f, 0.2f };
	CHECK(touches_plants(field.page(0), ball, 0.05f)); // A long log also touches with its middle.
	CHECK(touches_plants(field.page(0), crate({ 0.9f, 0.5f, 0.1f }, 0.0f), 0.0f));
	CHECK(!touches_plants(field.page(0), crate({ 1.1f, 0.5f, 0.1f }, 0.0f), 0.05f));
}

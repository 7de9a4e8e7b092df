// Pages of plants on their own nodes: bodies and contact work as in a field, in the pages' own axes.

#include "field/contact.hpp"
#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>

using namespace undergrowth;

namespace {

constexpr float RADIUS = 0.1f; // m, of tips.
constexpr float NEAR = 0.003f; // m, error after one step.
constexpr WindSnapshot CALM = {};
/// On a wall that faces +x: the page's up is the world's +x.
const glm::mat3 WALL = { { 0.0f, -1.0f, 0.0f }, { 1.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 1.0f } };

MotionPage page_of(Law law, const glm::vec3 &root) {
	MotionSpecies species = species_of(law);
	species.collision_radius = RADIUS;
	MotionPlant plant;
	plant.root = root;
	return { 0, species, &plant, 1, FIELD_STEP, true, MotionPage::Keeps::directions };
}

MovingBody ball(const glm::vec3 &place, float radius) {
	MovingBody body;
	body.from = body.to = place;
	body.radius = radius;
	return body;
}

glm::vec3 tip(const MotionPage &page, const PageFrame &frame) {
	return page.root(0) + page.length(0) * frame.outward(page.direction(0));
}

} // namespace

TEST_CASE("a ball pushes a plant on a wall as one on the ground, with everything turned") {
	const PageFrame walled = { &WALL, nullptr };
	const glm::vec3 root = { 3.0f, 2.0f, -1.0f };
	MotionPage ground = page_of(Law::spring, root);
	MotionPage wall = page_of(Law::spring, root);
	const glm::vec3 to_ball = { -0.15f, 0.95f, 0.1f };
	MovingBody pushing = ball(root + to_ball, 0.3f);
	pushing.velocity = { 0.5f, 0.1f, 0.0f };
	MovingBody turned = ball(root + WALL * to_ball, 0.3f);
	turned.velocity = WALL * pushing.velocity;
	CHECK(push_plants(ground, pushing) == 1);
	CHECK(push_plants(wall, turned, walled) == 1);
	CHECK(glm::distance(wall.state(0).direction, ground.state(0).direction) < 1e-6f);
	CHECK(glm::distance(wall.state(0).rate, ground.state(0).rate) < 1e-5f);
	CHECK(ground.state(0).direction.x > 0.1f);
	CHECK(touches_plant(wall, 0, turned, 0.01f, walled));
	CHECK(!touches_plant(wall, 0, turned, 0.01f));
}

TEST_CASE("a common velocity of body and root does not push") {
	const glm::vec3 root_velocity = { 2.0f, 0.0f, 0.0f };
	const PageFrame moving = { nullptr, &root_velocity };
	MovingBody body = ball({ -0.35f, 1.0f, 0.0f }, 0.3f);
	MotionPage page = page_of(Law::spring, {});
	body.velocity = root_velocity; // Both have the same velocity.
	CHECK(push_plants(page, body, moving) == 1);
	CHECK(glm::length(page.state(0).rate) < 1e-5f);
	page.settle();
	const MovingBody ahead = ball({ 0.35f, 1.0f, 0.0f }, 0.3f); // It is at rest, and the root moves the plant to it.
	CHECK(push_plants(page, ahead, moving) == 1);
	CHECK(glm::length(page.state(0).rate) < 1e-5f);
	page.settle();
	body.velocity = { 3.0f, 0.0f, 0.0f }; // It comes from behind, faster by 1 m/s.
	CHECK(push_plants(page, body, moving) == 1);
	CHECK(page.state(0).rate.x == doctest::Approx(1.0f).epsilon(0.02));
	page.settle();
	CHECK(push_plants(page, body) == 1);
	CHECK(page.state(0).rate.x == doctest::Approx(3.0f).epsilon(0.02));
}

TEST_CASE("lone pages touch like the pages of a field, to the bit") {
	for (const Law law : { Law::elasticity, Law::spring }) {
		FieldSimulation field((FieldSettings()));
		MotionSpecies species = species_of(law);
		species.collision_radius = RADIUS;
		field.add_species(species);
		field.set_wind({ { WindKind::constant, 0.0f }, 0.0f });
		std::vector<MotionPage> pages;
		for (int i = 0; i < 4; i++) {
			pages.push_back(page_of(law, { 0.3f * static_cast<float>(i), 0.0f, 0.0f }));
			MotionPlant plant;
			plant.root = pages.back().root(0);
			field.add_page(0, &plant, 1);
		}
		PageRefs refs;
		for (MotionPage &page : pages) {
			refs.add(page, nullptr);
		}
		TipContact of_field;
		TipContact of_lone;
		of_field.fit(field);
		of_lone.fit(refs);
		field.apply_impulse(0, 0, { 0.8f, 0.0f, 0.02f });
		pages[0].apply_impulse(0, { 0.8f, 0.0f, 0.02f });
		bool is_same = true;
		for (int i = 0; i < 120; i++) {
			field.step();
			of_field.resolve(field);
			for (MotionPage &page : pages) {
				page.step(CALM, {});
			}
			of_lone.resolve(refs);
			for (int one = 0; one < 4; one++) {
				is_same = is_same && refs.page(one).state(0).direction == field.page(one).state(0).direction;
			}
		}
		CHECK(is_same);
		CHECK(pages[1].state(0).direction != glm::vec3(0.0f, 1.0f, 0.0f));
	}
}

TEST_CASE("the tips of a plant on a wall and of one on the ground separate and lose their approach") {
	MotionPage ground = page_of(Law::elasticity, {});
	MotionPage wall = page_of(Law::spring, { -1.3f, 1.0f, 0.0f });
	PageRefs refs;
	refs.add(ground, nullptr);
	refs.add(wall, &WALL);
	TipContact contact;
	contact.fit(refs);
	const float at_rest = glm::distance(tip(ground, refs.frame(0)), tip(wall, refs.frame(1)));
	CHECK(at_rest == doctest::Approx(0.3f));
	// Both lean until their tips overlap, and stay so.
	const glm::vec3 leaning = glm::normalize(glm::vec3(-0.15f, 1.0f, 0.0f));
	ground.set_state(0, { leaning, glm::vec3(-leaning.y, leaning.x, 0.0f) });
	const float before = glm::distance(tip(ground, refs.frame(0)), tip(wall, refs.frame(1)));
	CHECK(before < 2.0f * RADIUS - 0.03f);
	contact.resolve(refs);
	CHECK(contact.contacts(0, 0) == 1);
	// The plant on the wall cannot yield along its own stem: its half remains.
	CHECK(glm::distance(tip(ground, refs.frame(0)), tip(wall, refs.frame(1))) >
			before + 0.4f * (2.0f * RADIUS - before));
	CHECK(ground.state(0).rate.x > -0.6f);
	CHECK(std::fabs(wall.state(0).direction.x) < 0.01f);
	for (int i = 0; i < 30; i++) {
		contact.resolve(refs);
	}
	const float after = glm::distance(tip(ground, refs.frame(0)), tip(wall, refs.frame(1)));
	CHECK(std::fabs(after - 2.0f * RADIUS) < NEAR);
	CHECK(wall.state(0).direction.y > 0.99f);
}

TEST_CASE("plants on a wall or a ceiling touch like those on the ground, with everything turned") {
	const glm::mat3 ceiling = { { 1.0f, 0.0f, 0.0f }, { 0.0f, -1.0f, 0.0f }, { 0.0f, 0.0f, -1.0f } };
	const glm::vec3 roots[] = { { 0.0f, 0.0f, 0.0f }, { 0.25f, 0.0f, 0.05f } };
	const TipState states[] = { { glm::normalize(glm::vec3(0.1f, 1.0f, 0.02f)), { 0.6f, -0.062f, 0.1f } },
		{ { 0.0f, 1.0f, 0.0f }, { -0.2f, 0.0f, 0.3f } } };
	const glm::mat3 ground(1.0f);
	TipState on_ground[2];
	for (const glm::mat3 *axes : { &ground, &WALL, &ceiling }) {
		MotionPage pages[] = { page_of(Law::spring, *axes * roots[0]), page_of(Law::spring, *axes * roots[1]) };
		PageRefs refs;
		for (int i = 0; i < 2; i++) {
			pages[i].set_state(0, states[i]);
			refs.add(pages[i], axes);
		}
		TipContact contact;
		contact.fit(refs);
		contact.resolve(refs);
		for (int i = 0; i < 2; i++) {
			const TipState now = pages[i].state(0);
			on_ground[i] = axes == &ground ? now : on_ground[i];
			CHECK(contact.contacts(i, 0) == 1);
			CHECK(glm::distance(now.rate, states[i].rate) > 0.2f); // A blow and a movement.
			CHECK(glm::distance(now.direction, states[i].direction) > 0.01f);
			CHECK(glm::distance(now.rate, on_ground[i].rate) < 1e-5f);
			CHECK(glm::distance(now.direction, on_ground[i].direction) < 1e-6f);
		}
	}
}

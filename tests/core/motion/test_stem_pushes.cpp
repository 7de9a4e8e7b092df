#include "../field/field_fixture.hpp"
#include "stem_plants.hpp"

#include "motion/part_bend.hpp"
#include "stem/stem_bones.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

using namespace undergrowth;

namespace {

constexpr int PLACES = 8;
constexpr int PLANTS = 500;
constexpr int BODIES = 60;
constexpr float SIDE = 6.0f; // m.

glm::vec3 noise_of(uint64_t stream, int index) {
	const auto number = static_cast<uint64_t>(index);
	return { signed_noise(stream, number), signed_noise(stream + 1, number), signed_noise(stream + 2, number) };
}

/// Stems of two modes that lean and swing, far from the origin. Their roots are turned by `turn`, their directions are
/// not.
MotionPage bent_stems(const glm::vec3 &middle, const glm::mat3 &turn = glm::mat3(1.0f)) {
	MotionSpecies species = species_of(Law::stem);
	species.stem = stem_of_two_modes(1.5, 0.1);
	std::vector<MotionPlant> plants;
	for (int i = 0; i < PLANTS; i++) {
		const glm::vec3 noise = noise_of(10, i);
		MotionPlant plant;
		plant.root = turn * (middle + SIDE * 0.5f * glm::vec3(noise.x, 0.05f * noise.y, noise.z));
		plant.length = 0.7f + 0.4f * noise.y;
		plant.rest = glm::normalize(glm::vec3(0.3f * noise.z, 1.0f, 0.3f * noise.x));
		plants.push_back(plant);
	}
	MotionPage page(0, species, plants.data(), PLANTS, FIELD_STEP, true);
	for (int i = 0; i < PLANTS; i++) {
		StemState state;
		const glm::vec3 noise = noise_of(20, i);
		state.place[0] = { 0.6f * noise.x, 0.6f * noise.y };
		state.place[1] = { 0.2f * noise.z, 0.2f * noise.x };
		page.set_stem(i, state);
	}
	return page;
}

/// A ball, a capsule or a box.
MovingBody body_near(const glm::vec3 &middle, int index) {
	const glm::vec3 place = noise_of(30, index);
	const glm::vec3 size = noise_of(40, index);
	MovingBody body;
	body.from = body.to = middle + glm::vec3(0.5f * SIDE * place.x, 0.5f + 0.5f * place.y, 0.5f * SIDE * place.z);
	body.radius = 0.2f + 0.1f * size.x;
	body.velocity = size;
	if (index % 3 > 0) {
		body.to += glm::vec3(0.3f * size.y, 0.5f, 0.3f * size.z);
	}
	if (index % 3 > 1) {
		const glm::vec3 along = glm::normalize(body.to - body.from);
		const glm::vec3 aside = glm::normalize(glm::cross(along, glm::vec3(1.0f, 0.0f, 0.2f)));
		body.half_width = 0.25f * aside;
		body.half_depth = 0.15f * glm::cross(along, aside);
	}
	return body;
}

/// How deep the deepest place of a stem is in a body (m), by the exact functions.
float depth_of(const MotionPage &page, int index, const MovingBody &body) {
	const StemState state = page.stem(index);
	float deepest = -1e9f;
	for (int place = 1; place <= PLACES; place++) {
		const float x = static_cast<float>(place) / PLACES;
		const glm::vec3 centre = stem_place(page.stem_constants(), state.place, x).centre;
		const glm::vec3 point = page.root(index) + page.length(index) * turned(centre, page.rest_bend(index));
		const float own = place == PLACES ? page.collision_radius() : 0.0f;
		deepest = std::max(deepest, body.radius + own - glm::distance(nearest_in_core(body, point), point));
	}
	return deepest;
}

} // namespace

TEST_CASE("a body pushes exactly the stems with a place in it") {
	for (const glm::vec3 &middle : { glm::vec3(0.0f), glm::vec3(700.0f, 20.0f, -400.0f) }) {
		const MotionPage stems = bent_stems(middle);
		int touched = 0;
		for (int b = 0; b < BODIES; b++) {
			const MovingBody body = body_near(middle, b);
			MotionPage page = stems;
			const int pushed = push_plants(page, body);
			int inside = 0;
			for (int i = 0; i < PLANTS; i++) {
				const float depth = depth_of(stems, i, body);
				const bool has_moved = page.stem(i).place[0] != stems.stem(i).place[0];
				inside += has_moved ? 1 : 0;
				if (std::fabs(depth) > 1e-3f) {
					CHECK(has_moved == (depth > 0.0f));
				}
			}
			CHECK(std::abs(inside - pushed) <= 2); // At the edge a push may be too small for a float.
			touched += pushed;
		}
		CHECK(touched > 200);
	}
}

TEST_CASE("a page pushes its stems as single stems are pushed, to the bit") {
	const MotionPage stems = bent_stems(glm::vec3(0.0f));
	for (int b = 0; b < BODIES; b++) {
		const MovingBody body = body_near(glm::vec3(0.0f), b);
		MotionPage page = stems;
		MotionPage alone = stems;
		push_plants(page, body);
		for (int i = 0; i < PLANTS; i++) {
			StemState state = stems.stem(i);
			const float thickness = std::max(stems.collision_radius(), 0.0f);
			if (push_plant(stems.stem_constants(), state, stems.rest_bend(i), stems.root(i), stems.length(i), thickness,
						body)) {
				alone.set_stem(i, state);
			}
			CHECK(page.stem(i).place[0] == alone.stem(i).place[0]);
			CHECK(page.stem(i).rate[1] == alone.stem(i).rate[1]);
		}
	}
}

TEST_CASE("stems of turned axes with moving roots are pushed as stems of the body's axes, to the bit") {
	const glm::mat3 wall = { { 0.0f, -1.0f, 0.0f }, { 1.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 1.0f } };
	std::vector<glm::vec3> velocities, turned_velocities;
	for (int i = 0; i < PLANTS; i++) {
		velocities.push_back(0.4f * noise_of(50, i));
		turned_velocities.push_back(wall * velocities.back());
	}
	int touched = 0;
	for (int b = 0; b < BODIES; b++) {
		MotionPage upright = bent_stems(glm::vec3(0.0f));
		MotionPage turned = bent_stems(glm::vec3(0.0f), wall);
		const MovingBody body = body_near(glm::vec3(0.0f), b);
		MovingBody turned_body = body;
		for (glm::vec3 MovingBody::*vector : { &MovingBody::from, &MovingBody::to, &MovingBody::velocity,
					 &MovingBody::half_width, &MovingBody::half_depth }) {
			turned_body.*vector = wall * (body.*vector);
		}
		const int pushed = push_plants(upright, body, { nullptr, velocities.data() });
		CHECK(push_plants(turned, turned_body, { &wall, turned_velocities.data() }) == pushed);
		touched += pushed;
		for (int i = 0; i < PLANTS; i++) {
			for (int k = 0; k < 2; k++) {
				REQUIRE(turned.stem(i).place[k] == upright.stem(i).place[k]);
				REQUIRE(turned.stem(i).rate[k] == upright.stem(i).rate[k]);
			}
		}
	}
	CHECK(touched > 100);
}

TEST_CASE("the boxes of blocks hold their plants after plants were moved, removed and added") {
	MotionPage page = bent_stems(glm::vec3(0.0f));
	MotionPlant far;
	far.root = { 50.0f, 0.0f, 0.0f };
	page.set_plant(3, far);
	page.remove(page.size() - 1);
	page.add(&far, 1);
	page.remove(100); // The last one takes its row.
	for (int i = 0; i < page.size(); i++) {
		const MotionPage::BlockBox &box = page.block_box(i / MotionPage::BLOCK_ROWS);
		CHECK(box.low_x <= page.root(i).x - page.length(i));
		CHECK(box.high_x >= page.root(i).x + page.length(i));
		CHECK(box.low_z <= page.root(i).z - page.length(i));
		CHECK(box.high_z >= page.root(i).z + page.length(i));
	}
}

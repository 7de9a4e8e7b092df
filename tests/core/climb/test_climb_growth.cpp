#include "../golden.hpp"

#include "climb/climb_growth.hpp"
#include "climb/surface_grid.hpp"

#include <doctest/doctest.h>

#include "climb_fixture.hpp"

#include <algorithm>
#include <limits>

namespace {

ClimbSettings settings_of(uint64_t seed) {
	ClimbSettings settings;
	settings.seed = seed;
	settings.root = { 0.0f, 0.05f, 0.01f };
	return settings;
}

uint64_t hash_of(const Climb &climb) {
	GoldenHash hash;
	for (const ClimbPoint &point : climb.points) {
		const float numbers[] = { point.place.x, point.place.y, point.place.z, point.normal.x, point.normal.y,
			point.normal.z, point.radius, point.to_tip };
		hash.add(numbers, 8);
	}
	for (const ClimbLeaf &leaf : climb.leaves) {
		const float numbers[] = { leaf.place.x, leaf.place.y, leaf.place.z, leaf.out.x, leaf.out.y, leaf.out.z,
			leaf.down.x, leaf.down.y, leaf.down.z, leaf.size, leaf.age, leaf.phase };
		hash.add(numbers, 12);
	}
	return hash.value();
}

float max_distance(const Climb &climb, float (*distance)(const glm::vec3 &)) {
	float farthest = 0.0f;
	for (const ClimbPoint &point : climb.points) {
		farthest = std::max(farthest, distance(point.place));
	}
	return farthest;
}

} // namespace

TEST_CASE("a climber stays on a wall and in front of it") {
	const Climb climb = grown_on(wall_of(20.0f, 20.0f), settings_of(1));
	REQUIRE(climb.points.size() > 500);
	for (const ClimbPoint &point : climb.points) {
		CHECK(point.place.z > 0.001f);
		CHECK(point.place.z < 0.25f);
		CHECK(point.is_attached);
		CHECK(glm::distance(point.normal, glm::vec3(0.0f, 0.0f, 1.0f)) < 0.05f);
	}
}

TEST_CASE("a climber grows on the side of a wall on which its root is, for both windings") {
	ClimbSupport wall = wall_of(20.0f, 20.0f);
	ClimbSettings settings = settings_of(1);
	settings.root.z = -0.02f;
	for (const ClimbPoint &point : grown_on(wall, settings).points) {
		CHECK(point.place.z < 0.0f);
	}
	std::swap(wall.corners[1], wall.corners[2]);
	std::swap(wall.corners[4], wall.corners[5]);
	for (const ClimbPoint &point : grown_on(wall, settings).points) {
		CHECK(point.place.z < 0.0f);
	}
}

TEST_CASE("a climber stays on a sphere") {
	ClimbSettings settings = settings_of(2);
	settings.root = { 0.0f, -0.9f, 0.5f };
	settings.max_hanging = 0.0f;
	const Climb climb = grown_on(sphere_of(1.0f), settings);
	REQUIRE(climb.points.size() > 500);
	const auto apart = [](const glm::vec3 &place) { return std::fabs(glm::length(place) - 1.0f); };
	CHECK(max_distance(climb, apart) < 0.03f);
	CHECK(std::any_of(climb.points.begin(), climb.points.end(), [](const ClimbPoint &p) { return p.place.y > 0.8f; }));
}

TEST_CASE("main shoots reach the length that was set") {
	for (const float length : { 0.5f, 3.0f, 12.0f }) {
		ClimbSettings settings = settings_of(3);
		settings.length = length;
		const Climb climb = grown_on(wall_of(60.0f, 60.0f), settings);
		int mains = 0;
		for (const ClimbShoot &shoot : climb.shoots) {
			const float grown = climb.points[static_cast<std::size_t>(shoot.first)].to_tip;
			mains += shoot.order == 0 ? 1 : 0;
			CHECK((shoot.order > 0 || std::fabs(grown - length) < 0.05f));
			CHECK(grown < length + 0.05f);
		}
		CHECK(mains == settings.shoots);
	}
}

TEST_CASE("a shoot turns around the edges of a box") {
	ClimbSupport box;
	add_box(box, { -1.0f, 0.0f, -1.0f }, { 1.0f, 2.0f, 0.0f });
	ClimbSettings settings = settings_of(4);
	settings.branching = 0.0f;
	settings.random_weight = 0.1f;
	settings.shoots = 1;
	settings.root = { 0.0f, 1.5f, 0.01f };
	settings.length = 1.1f;
	const Climb climb = grown_on(box, settings);
	const glm::vec3 tip = climb.points.back().place;
	CHECK(tip.y == doctest::Approx(2.0).epsilon(0.01));
	CHECK(tip.z < -0.4f);
	CHECK(climb.points.back().normal.y > 0.95f);
	for (const ClimbPoint &point : climb.points) {
		CHECK((point.place.y > 2.0f || point.place.z > 0.0f));
	}
}

TEST_CASE("a shoot turns in the corner between a floor and a wall") {
	ClimbSupport room = wall_of(10.0f, 5.0f);
	add_quad(room, { -5.0f, 0.0f, 0.0f }, { 5.0f, 0.0f, 0.0f }, { 5.0f, 0.0f, 5.0f }, { -5.0f, 0.0f, 5.0f }, 1);
	ClimbSettings settings = settings_of(5);
	settings.root = { 0.0f, 0.02f, 0.6f };
	settings.path = { { 0.0f, 0.0f, 0.3f }, { 0.0f, 0.0f, 0.02f } };
	settings.length = 3.0f;
	const Climb climb = grown_on(room, settings);
	int on_wall = 0;
	for (const ClimbPoint &point : climb.points) {
		CHECK(point.place.y > 0.0f);
		CHECK(point.place.z > 0.0f);
		on_wall += point.body == 0 ? 1 : 0;
	}
	CHECK(on_wall > static_cast<int>(climb.points.size()) / 2);
}

TEST_CASE("main shoots follow a path") {
	ClimbSettings settings = settings_of(6);
	settings.path = { { 1.5f, 0.5f, 0.0f }, { 3.0f, 0.4f, 0.0f }, { 3.2f, 3.0f, 0.0f } };
	settings.length = 6.0f;
	settings.shoots = 2;
	const Climb climb = grown_on(wall_of(20.0f, 20.0f), settings);
	for (const glm::vec3 &goal : settings.path) {
		float nearest = 1e9f;
		for (const ClimbPoint &point : climb.points) {
			nearest = std::min(nearest, glm::distance(point.place, goal));
		}
		CHECK(nearest < 0.2f);
	}
}

TEST_CASE("a shoot without support hangs down and ends") {
	ClimbSettings settings = settings_of(7);
	settings.shoots = 1;
	settings.branching = 0.0f;
	settings.max_hanging = 0.5f;
	settings.light_weight = 0.0f;
	ClimbSupport shelf; // An open sheet of which the shoot grows off the edge.
	add_quad(shelf, { -1.0f, 1.0f, 0.0f }, { 1.0f, 1.0f, 0.0f }, { 1.0f, 1.0f, 0.4f }, { -1.0f, 1.0f, 0.4f });
	settings.root = { 0.0f, 1.02f, 0.1f };
	settings.path = { { 0.0f, 1.0f, 0.3f } };
	settings.random_weight = 0.1f;
	settings.length = 5.0f;
	const Climb climb = grown_on(shelf, settings);
	float hanging = 0.0f;
	for (std::size_t i = 1; i < climb.points.size(); i++) {
		const ClimbPoint &point = climb.points[i];
		hanging += point.is_attached ? 0.0f : glm::distance(point.place, climb.points[i - 1].place);
	}
	CHECK(hanging > 0.4f);
	CHECK(hanging < 0.6f);
	CHECK(climb.points.front().to_tip < 2.0f);
	CHECK(climb.points.back().place.y < 0.75f);
}

TEST_CASE("the same seed gives the same plant, another seed another one") {
	const ClimbSupport wall = wall_of(20.0f, 20.0f);
	const uint64_t first = hash_of(grown_on(wall, settings_of(8)));
	CHECK(hash_of(grown_on(wall, settings_of(8))) == first);
	CHECK(hash_of(grown_on(wall, settings_of(9))) != first);
}

TEST_CASE("a climber is the same on every platform") {
	ClimbSupport box;
	add_box(box, { -1.0f, 0.0f, -1.0f }, { 1.0f, 2.0f, 0.0f });
	CHECK(hash_of(grown_on(box, settings_of(10))) == 0x8a499c9fb83d1793ull);
}

TEST_CASE("no leaf is inside a support") {
	ClimbSupport house;
	add_box(house, { -2.0f, 0.0f, -1.0f }, { 2.0f, 2.0f, 0.0f });
	add_box(house, { 0.5f, -0.1f, -0.5f }, { 1.0f, 3.0f, 0.4f }); // A pillar with inner corners.
	ClimbSettings settings = settings_of(11);
	settings.length = 5.0f;
	settings.branching = 5.0f;
	const Climb climb = grown_on(house, settings);
	REQUIRE(climb.leaves.size() > 400);
	const auto is_in = [](const glm::vec3 &p, const glm::vec3 &low, const glm::vec3 &high) {
		return p.x > low.x && p.y > low.y && p.z > low.z && p.x < high.x && p.y < high.y && p.z < high.z;
	};
	int inside = 0;
	for (const ClimbLeaf &leaf : climb.leaves) {
		CHECK(std::fabs(glm::dot(leaf.out, leaf.down)) < 1e-3f);
		const LeafOutline outline(leaf, settings.leaf_reach);
		for (const glm::vec3 &p : { leaf.place, outline.tip, outline.left, outline.right }) {
			inside += is_in(p, { -2.0f, 0.0f, -1.0f }, { 2.0f, 2.0f, 0.0f }) ||
					is_in(p, { 0.5f, -0.1f, -0.5f }, { 1.0f, 3.0f, 0.4f });
		}
	}
	CHECK(inside == 0);
}

TEST_CASE("leaves point down on a wall, and are small at the tips") {
	const Climb climb = grown_on(wall_of(20.0f, 20.0f), settings_of(12));
	double down = 0.0;
	float largest = 0.0f, smallest = 1e9f;
	for (const ClimbLeaf &leaf : climb.leaves) {
		down -= static_cast<double>(leaf.down.y);
		largest = std::max(largest, leaf.size);
		smallest = std::min(smallest, leaf.size);
		CHECK(leaf.out.z > 0.8f);
		CHECK((leaf.age > 0.1f || leaf.size < 0.6f));
	}
	CHECK(down / static_cast<double>(climb.leaves.size()) > 0.6);
	CHECK(smallest < 0.45f);
	CHECK(largest > 1.1f);
}

TEST_CASE("invalid input of a climber gives one error and no plant") {
	Climb climb = grown_on(wall_of(2.0f, 2.0f), settings_of(13));
	const auto fault_of = [&](const ClimbSupport &support, const ClimbSettings &settings) {
		const std::string fault = grow_climb(support, settings, climb);
		CHECK(climb.points.empty());
		return fault;
	};
	ClimbSettings settings = settings_of(13);
	CHECK(fault_of({}, settings).find("no surface") != std::string::npos);
	ClimbSupport broken = wall_of(2.0f, 2.0f);
	broken.corners[4].y = std::numeric_limits<float>::quiet_NaN();
	CHECK(fault_of(broken, settings).find("not finite") != std::string::npos);
	settings.root = { 0.0f, 0.0f, 5.0f };
	CHECK(fault_of(wall_of(2.0f, 2.0f), settings).find("Move the node") != std::string::npos);
	settings = settings_of(13);
	settings.length = -1.0f;
	CHECK(fault_of(wall_of(2.0f, 2.0f), settings) == "length cannot be -1. Use 0.05 to 200.");
	settings = settings_of(13);
	settings.path = { { std::numeric_limits<float>::infinity(), 0.0f, 0.0f } };
	CHECK(fault_of(wall_of(2.0f, 2.0f), settings).find("path") == 0);
}

TEST_CASE("a ray finds the first surface") {
	ClimbSupport box;
	add_box(box, { -1.0f, 0.0f, -1.0f }, { 1.0f, 2.0f, 0.0f });
	glm::vec3 place(0.0f);
	REQUIRE(first_on_ray(box, { 0.3f, 0.5f, 4.0f }, { 0.0f, 0.0f, -1.0f }, place));
	CHECK(glm::distance(place, glm::vec3(0.3f, 0.5f, 0.0f)) < 1e-4f);
	CHECK_FALSE(first_on_ray(box, { 0.3f, 0.5f, 4.0f }, { 0.0f, 0.0f, 1.0f }, place));
}

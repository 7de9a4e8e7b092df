#include "placement/ground_grid.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace undergrowth;

namespace {

using Ground = std::function<float(float, float)>;

/// Plants over a square around the origin, `density` per square metre.
FieldPlants plants_in(float side, float density) {
	FieldPlants plants;
	const float gap = 1.0f / std::sqrt(density);
	for (float x = -0.5f * side + 0.37f * gap; x < 0.5f * side; x += gap) {
		for (float z = -0.5f * side + 0.61f * gap; z < 0.5f * side; z += gap) {
			PlacedPlant plant;
			plant.root = { x, 0.0f, z };
			plants.add(plant);
		}
	}
	return plants;
}

struct Found {
	int points = 0;
	int single = 0; ///< Plants that need a separate query.
	float max_error = 0.0f; ///< m, of all other plants.
	float max_turn = 0.0f; ///< rad, of their normals.
};

Found survey(const FieldPlants &plants, float spacing, const Ground &ground) {
	GroundGrid grid;
	Found found;
	REQUIRE(grid.prepare(plants, spacing));
	grid.mark(plants, 0, plants.size() / 2);
	grid.mark(plants, plants.size() / 2, plants.size());
	found.points = grid.list_points();
	for (int i = 0; i < found.points; i++) {
		grid.set_height(i, ground(grid.point(i).x, grid.point(i).y));
	}
	for (std::size_t i = 0; i < plants.x.size(); i++) {
		const float x = plants.x[i];
		const float z = plants.z[i];
		float height = 0.0f;
		glm::vec3 normal(0.0f);
		if (!grid.find(x, z, height, normal)) {
			found.single++;
			continue;
		}
		const float exact = ground(x, z);
		CHECK(std::isfinite(height) == std::isfinite(exact));
		if (!std::isfinite(height)) {
			continue;
		}
		const float aside = 0.01f;
		const glm::vec3 up(-(ground(x + aside, z) - exact) / aside, 1.0f, -(ground(x, z + aside) - exact) / aside);
		found.max_error = std::max(found.max_error, std::abs(height - exact));
		found.max_turn = std::max(found.max_turn, glm::distance(glm::normalize(up), glm::normalize(normal)));
	}
	return found;
}

} // namespace

TEST_CASE("on rolling ground a 0.5 m grid needs a seventh of the queries of 40 plants per square metre") {
	const FieldPlants plants = plants_in(16.0f, 40.0f);
	const Found found = survey(
			plants, 0.5f, [](float x, float z) { return 2.0f * std::sin(0.16f * x) * std::cos(0.12f * z) + 0.1f * z; });
	CHECK(found.single == 0);
	CHECK(found.points * 7 < plants.size());
	CHECK(found.max_error < 0.25f * GroundGrid::MAX_BEND);
	CHECK(found.max_turn < 0.03f);
}

TEST_CASE("a slope has its height and its normal exactly") {
	const Found found = survey(plants_in(6.0f, 12.0f), 0.5f, [](float x, float z) { return x - 0.25f * z; });
	CHECK(found.single == 0);
	CHECK(found.max_error < 1e-4f);
	CHECK(found.max_turn < 0.01f);
}

TEST_CASE("plants at the edge of the ground and at a step need a separate query") {
	const FieldPlants plants = plants_in(12.0f, 12.0f);
	const auto with_hole = [](float x, float z) { return x * x + z * z < 4.0f ? NAN : 1.0f; };
	const Found hole = survey(plants, 0.5f, with_hole);
	CHECK(hole.single > 0);
	CHECK(hole.single < plants.size() / 4);
	CHECK(hole.max_error < 1e-6f);
	for (const float top : { 0.1f, 3.0f }) {
		const Found step = survey(plants, 0.5f, [top](float x, float) { return x > 1.3f ? top : 0.0f; });
		CAPTURE(top);
		CHECK(step.single > 0);
		CHECK(step.single < plants.size() / 3);
		CHECK(step.max_error < 1e-6f);
	}
}

TEST_CASE("a cell's height does not depend on the other plants") {
	const Ground ground = [](float x, float z) { return 0.4f * std::sin(x) * std::sin(0.7f * z); };
	FieldPlants one;
	one.add(plants_in(6.0f, 12.0f).plant(100));
	float heights[2] = {};
	int number = 0;
	for (const FieldPlants &plants : { plants_in(6.0f, 12.0f), one }) {
		GroundGrid grid;
		REQUIRE(grid.prepare(plants, 0.25f));
		grid.mark(plants, 0, plants.size());
		const int count = grid.list_points();
		for (int i = 0; i < count; i++) {
			grid.set_height(i, ground(grid.point(i).x, grid.point(i).y));
		}
		glm::vec3 normal(0.0f);
		CHECK(grid.find(one.x[0], one.z[0], heights[number++], normal));
	}
	CHECK(heights[0] == heights[1]);
}

TEST_CASE("a few distant plants get no grid") {
	FieldPlants plants;
	for (const float x : { -1.0e5f, 0.0f, 1.0e5f }) {
		PlacedPlant plant;
		plant.root = { x, 0.0f, x };
		plants.add(plant);
	}
	GroundGrid grid;
	CHECK_FALSE(grid.prepare(plants, 0.5f));
	CHECK_FALSE(grid.prepare(FieldPlants(), 0.5f));
}

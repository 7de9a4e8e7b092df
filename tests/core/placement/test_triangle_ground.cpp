#include "placement/triangle_ground.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <cstdint>

using namespace undergrowth;

namespace {

struct Found {
	std::vector<float> heights;
	std::vector<glm::vec3> normals;
};

Found ground_at(const std::vector<glm::vec3> &corners, const std::vector<glm::vec2> &places,
		GroundChoice choice = GroundChoice::highest) {
	FieldPlants plants;
	for (const glm::vec2 &place : places) {
		PlacedPlant plant;
		plant.root = { place.x, 0.0f, place.y };
		plants.add(plant);
	}
	Found found;
	find_ground(corners.data(), static_cast<int>(corners.size() / 3), choice, plants, found.heights, found.normals);
	return found;
}

float hill(float x, float z) {
	return 0.1f * x - 0.25f * z;
}

} // namespace

TEST_CASE("plants are on the slope of a mesh of many triangles, at any position") {
	std::vector<glm::vec3> corners;
	for (int column = -20; column < 20; column++) {
		for (int row = -10; row < 10; row++) {
			const auto x = static_cast<float>(column);
			const auto z = static_cast<float>(row);
			const glm::vec3 a(x, hill(x, z), z), b(x + 1.0f, hill(x + 1.0f, z), z);
			const glm::vec3 c(x, hill(x, z + 1.0f), z + 1.0f), d(x + 1.0f, hill(x + 1.0f, z + 1.0f), z + 1.0f);
			corners.insert(corners.end(), { a, b, c, b, c, d }); // One of each two has the opposite winding.
		}
	}
	std::vector<glm::vec2> places;
	for (int i = 0; i < 500; i++) {
		places.push_back({ -19.9f + 39.8f * static_cast<float>(i * 37 % 500) / 500.0f,
				-9.9f + 19.8f * static_cast<float>(i) / 500.0f });
	}
	const Found found = ground_at(corners, places);
	const glm::vec3 normal = glm::normalize(glm::vec3(-0.1f, 1.0f, 0.25f));
	for (std::size_t i = 0; i < places.size(); i++) {
		CHECK(found.heights[i] == doctest::Approx(hill(places[i].x, places[i].y)).epsilon(1e-4));
		CHECK(glm::distance(glm::normalize(found.normals[i]), normal) < 1e-4f);
	}
}

TEST_CASE("with two floors plants are on the chosen one") {
	const std::vector<glm::vec3> lower = { { -1, 0, -1 }, { 1, 0, -1 }, { 0, 0, 1 } };
	const std::vector<glm::vec3> upper = { { -1, 2, -1 }, { 1, 2, -1 }, { 0, 2, 1 } };
	std::vector<glm::vec3> both = upper;
	both.insert(both.end(), lower.begin(), lower.end());
	CHECK(ground_at(both, { { 0.0f, 0.0f } }).heights[0] == 2.0f);
	CHECK(ground_at(both, { { 0.0f, 0.0f } }, GroundChoice::lowest).heights[0] == 0.0f);
	both = lower;
	both.insert(both.end(), upper.begin(), upper.end());
	CHECK(ground_at(both, { { 0.0f, 0.0f } }).heights[0] == 2.0f);
	CHECK(ground_at(both, { { 0.0f, 0.0f } }, GroundChoice::lowest).heights[0] == 0.0f);
}

TEST_CASE("a mesh or a position at the limits of numbers has no ground and causes no fault") {
	const float far = 3e38f;
	const std::vector<glm::vec3> near = { { 0, 1, 0 }, { 4, 1, 0 }, { 0, 1, 4 } };
	CHECK(std::isnan(ground_at(near, { { 1e31f, -1e31f } }).heights[0]));
	std::vector<glm::vec3> wide = near;
	wide.insert(wide.end(), { { -far, 0, -far }, { far, 0, -far }, { 0, 0, far } });
	CHECK(ground_at(wide, { { 1.0f, 1.0f } }).heights.size() == 1);
	wide.push_back({ std::nanf(""), 0, 0 });
	wide.insert(wide.end(), { { 1, 0, 1 }, { 2, 0, 2 } });
	CHECK(ground_at(wide, { { 1.0f, 1.0f } }).heights.size() == 1);
}

TEST_CASE("there is no ground beside a mesh, in its holes, on its walls and without a mesh") {
	const std::vector<glm::vec3> one = { { 0, 1, 0 }, { 4, 1, 0 }, { 0, 1, 4 } };
	for (const glm::vec2 &place : { glm::vec2(3.0f, 3.0f), glm::vec2(-1.0f, 1.0f), glm::vec2(1.0f, 100.0f) }) {
		CHECK(std::isnan(ground_at(one, { place }).heights[0]));
	}
	const std::vector<glm::vec3> wall = { { 0, 0, 0 }, { 4, 0, 0 }, { 2, 4, 0 } };
	CHECK(std::isnan(ground_at(wall, { { 2.0f, 0.0f } }).heights[0]));
	CHECK(std::isnan(ground_at({}, { { 0.0f, 0.0f } }).heights[0]));
}

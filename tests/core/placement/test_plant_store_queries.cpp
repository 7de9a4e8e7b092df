#include "placement/test_plant_store_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace undergrowth;

TEST_CASE("exactly the plants along lines and in polygons are found, at any height") {
	const PlantStore store = filled_store();
	const glm::vec2 from = { -9.0f, 2.0f };
	const glm::vec2 to = { 7.0f, -3.0f };
	const Polygon polygon = { { -10.0f, -10.0f }, { 12.0f, -6.0f }, { 0.0f, 15.0f } };
	std::vector<PlantRef> along;
	std::vector<PlantRef> in_polygon;
	std::vector<PlantRef> at_point;
	store.find_along(from, to, 2.5f, along);
	store.find_in_polygon(polygon, in_polygon);
	store.find_along(from, from, 2.5f, at_point);
	std::size_t beside_line = 0;
	std::size_t beside_point = 0;
	std::size_t polygons = 0;
	for (int number = 0; number < store.chunk_count(); number++) {
		for (int slot = 0; slot < store.chunk(number).size(); slot++) {
			const glm::vec3 root = store.chunk(number).root(slot);
			const glm::vec2 place = { root.x, root.z };
			double nearest = 1.0e9;
			for (int i = 0; i <= 2000; i++) {
				nearest = std::min(nearest,
						static_cast<double>(
								glm::distance(place, from + (to - from) * (static_cast<float>(i) / 2000.0f))));
			}
			beside_line += static_cast<std::size_t>(nearest <= 2.5);
			beside_point += static_cast<std::size_t>(glm::distance(place, from) <= 2.5f);
			polygons += static_cast<std::size_t>(is_inside(polygon, place));
		}
	}
	CHECK(std::abs(static_cast<double>(along.size()) - static_cast<double>(beside_line)) <= 1.0);
	CHECK(beside_line > 300);
	CHECK(at_point.size() == beside_point);
	CHECK(in_polygon.size() == polygons);
	CHECK(polygons > 800);
	std::vector<PlantRef> none;
	store.find_along(from, to, -1.0f, none);
	store.find_in_polygon({ { 0.0f, 0.0f }, { 1.0f, 1.0f } }, none);
	CHECK(none.empty());
}

TEST_CASE("queries in spheres and boxes return exactly the plants there") {
	const PlantStore store = filled_store(100.0f);
	for (const glm::vec3 &centre : { glm::vec3(0.0f), glm::vec3(31.0f, 0.0f, -16.0f), glm::vec3(300.0f, 0.0f, 0.0f) }) {
		for (const float radius : { 0.0f, 1.5f, 20.0f, 1.0e4f }) {
			std::vector<PlantRef> found;
			store.find_in_sphere(centre, radius, found);
			std::vector<PlantRef> boxed;
			store.find_in_box(centre - radius, centre + radius, boxed);
			std::size_t in_sphere = 0;
			std::size_t in_box = 0;
			for (int number = 0; number < store.chunk_count(); number++) {
				for (int slot = 0; slot < store.chunk(number).size(); slot++) {
					const glm::vec3 way = store.chunk(number).root(slot) - centre;
					const glm::dvec3 exact = glm::dvec3(way);
					in_sphere += exact.x * exact.x + exact.y * exact.y + exact.z * exact.z <=
									static_cast<double>(radius) * static_cast<double>(radius)
							? 1
							: 0;
					in_box += std::fabs(way.x) <= radius && std::fabs(way.y) <= radius && std::fabs(way.z) <= radius;
				}
			}
			CHECK(found.size() == in_sphere);
			CHECK(boxed.size() == in_box);
		}
	}
	std::vector<PlantRef> none;
	store.find_in_sphere({ 0.0f, 0.0f, 0.0f }, -1.0f, none);
	store.find_in_sphere({ 0.0f, 0.0f, 0.0f }, std::nanf(""), none);
	CHECK(none.empty());
}

TEST_CASE("unused ids find no plant") {
	const PlantStore store = filled_store(10.0f);
	for (const PlantId id : { PlantId(-1), PlantId(0), added_plant_id(0), generated_plant_id(1e5f, 1e5f, SPACING) }) {
		CHECK(store.find(id).chunk == -1);
	}
}

TEST_CASE("the nearest plant is found at any distance, and none beyond the radius") {
	const PlantStore store = filled_store();
	const auto away = [&](const PlantRef &place, const glm::vec3 &from) {
		return glm::distance(store.chunk(place.chunk).root(place.slot), from);
	};
	for (const glm::vec3 &from : { glm::vec3(0.0f), glm::vec3(12.3f, 0.4f, -7.1f), glm::vec3(400.0f, 30.0f, 0.0f) }) {
		std::vector<PlantRef> all;
		store.find_in_sphere(from, 1000.0f, all);
		float min = 1.0e9f;
		for (const PlantRef &place : all) {
			min = std::min(min, away(place, from));
		}
		const PlantRef found = store.find_nearest(from, std::numeric_limits<float>::infinity());
		REQUIRE(found.chunk >= 0);
		CHECK(away(found, from) == min);
		CHECK(store.find_nearest(from, 1.01f * min) == found);
		CHECK(store.find_nearest(from, 0.99f * min).chunk < 0);
	}
	CHECK(store.find_nearest({ 0.0f, 0.0f, 0.0f }, -1.0f).chunk < 0);
	CHECK(PlantStore().find_nearest({ 0.0f, 0.0f, 0.0f }, std::numeric_limits<float>::infinity()).chunk < 0);
}

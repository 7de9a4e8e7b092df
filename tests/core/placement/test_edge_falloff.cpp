#include "placement/edge_falloff.hpp"

#include "placement/density_brush.hpp"
#include "placement/near_edges.hpp"
#include "placement/plant_id.hpp"
#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <vector>

using namespace undergrowth;

namespace {

constexpr float REACH = 1.5f; ///< m.

PlacementRequest soft_field(float falloff) {
	PlacementRequest request = square_field(24.0f, 30.0f, 2);
	request.exclusions = { rectangle({ 4.0f, 6.0f }, { -2.0f, 3.0f }) };
	request.edge_falloff = falloff;
	return request;
}

/// By id.
std::map<PlantId, PlacedPlant> plants_of(const PlacementRequest &request) {
	const double spacing = 1.0 / std::sqrt(static_cast<double>(request.density));
	const FieldPlants plants = placed(request);
	std::map<PlantId, PlacedPlant> by_id;
	for (int i = 0; i < plants.size(); i++) {
		const PlacedPlant plant = plants.plant(i);
		by_id[generated_plant_id(plant.root.x, plant.root.z, spacing)] = plant;
	}
	return by_id;
}

double distance_to(const Polygon &polygon, const glm::vec3 &root) {
	double square = std::numeric_limits<double>::max();
	for_each_edge(polygon,
			[&](const AreaEdge &edge) { square = std::min(square, edge.square_distance({ root.x, root.z })); });
	return std::sqrt(square);
}

double edge_distance(const PlacementRequest &request, const glm::vec3 &root) {
	return std::min(distance_to(request.area, root), distance_to(request.exclusions[0], root));
}

} // namespace

TEST_CASE("an edge falloff removes and lowers plants near edges and changes nothing else") {
	const std::map<PlantId, PlacedPlant> all = plants_of(soft_field(0.0f));
	const PlacementRequest request = soft_field(REACH);
	const std::map<PlantId, PlacedPlant> left = plants_of(request);
	CHECK(left.size() > all.size() / 2);
	for (const auto &[id, plant] : left) {
		const auto was = all.find(id);
		REQUIRE(was != all.end());
		CHECK(plant.root == was->second.root);
		CHECK(plant.species == was->second.species);
		CHECK(plant.variant == was->second.variant);
		CHECK(plant.turn == was->second.turn);
		CHECK(plant.scale == was->second.scale);
		CHECK(plant.height <= was->second.height);
	}
	for (const auto &[id, plant] : all) {
		if (edge_distance(request, plant.root) >= static_cast<double>(REACH)) {
			REQUIRE(left.count(id) == 1);
			CHECK(left.at(id).height == plant.height);
		}
	}
}

TEST_CASE("plants are fewer and lower the nearer an edge or an exclusion is") {
	const PlacementRequest request = soft_field(REACH);
	const std::map<PlantId, PlacedPlant> left = plants_of(request);
	constexpr int BANDS = 4;
	for (const Polygon &edges : { request.area, request.exclusions[0] }) {
		int remaining[BANDS] = {};
		int all[BANDS] = {};
		double heights[BANDS] = {};
		for (const auto &[id, plant] : plants_of(soft_field(0.0f))) {
			const int band = static_cast<int>(distance_to(edges, plant.root) / static_cast<double>(REACH) * BANDS);
			if (band < BANDS) {
				all[band]++;
				remaining[band] += static_cast<int>(left.count(id));
				heights[band] += left.count(id) == 1 ? static_cast<double>(left.at(id).height / plant.height) : 0.0;
			}
		}
		for (int i = 0; i < BANDS; i++) {
			CAPTURE(i);
			REQUIRE(all[i] > 50);
			REQUIRE(remaining[i] > 0);
			const double density = remaining[i] / static_cast<double>(all[i]);
			const double height = heights[i] / remaining[i];
			CHECK(density > (i == 3 ? 0.9 : 0.02));
			CHECK(density < (i == 0 ? 0.35 : 1.01));
			CHECK(height < (i == 0 ? 0.75 : 1.01));
			CHECK(height > (i == 3 ? 0.85 : EdgeFalloff::LOWEST));
			if (i > 0) {
				CHECK(density > remaining[i - 1] / static_cast<double>(all[i - 1]));
				CHECK(height > heights[i - 1] / remaining[i - 1]);
			}
		}
	}
}

TEST_CASE("the border with an edge falloff is irregular") {
	std::vector<double> borders; // m: where half of the plants remain, along an edge.
	for (int i = 0; i < 400; i++) {
		double distance = 0.0;
		while (edge_falloff_at({ 0.1f * static_cast<float>(i), static_cast<float>(distance) }, distance, 1.5).density <
				0.5f) {
			distance += 0.01;
		}
		borders.push_back(distance);
	}
	std::sort(borders.begin(), borders.end());
	CHECK(borders.front() < 0.4);
	CHECK(borders.back() > 0.9);
	CHECK(borders.back() < 1.5);
	CHECK(borders[300] - borders[100] > 0.2);
}

TEST_CASE("with a map only exclusions have edges") {
	PlacementRequest request = soft_field(0.0f);
	DensityMap map;
	for (PlacementSpecies &species : request.species) {
		species.layer = map.need_layer("Grass");
	}
	fill_polygon(map, 0, request.area, 1.0f);
	request.map = std::make_shared<DensityMap>(std::move(map));
	const std::map<PlantId, PlacedPlant> all = plants_of(request);
	request.edge_falloff = REACH;
	const std::map<PlantId, PlacedPlant> left = plants_of(request);
	int gone = 0;
	for (const auto &[id, plant] : all) {
		if (left.count(id) == 0) {
			gone++;
			CHECK(distance_to(request.exclusions[0], plant.root) < static_cast<double>(REACH));
		}
	}
	CHECK(gone > 50);
}

TEST_CASE("plants with an edge falloff are the same on every platform") {
	CHECK(hash_of(placed(soft_field(REACH))) == 5792392733296565723ull);
}

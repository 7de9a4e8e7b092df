// Fields with painted plants/m².

#include "placement/density_brush.hpp"
#include "placement/placement.hpp"
#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

using namespace undergrowth;

namespace {

constexpr float SIDE = 60.0f;
constexpr float DENSITY = 12.0f;
constexpr int GRASS = 0;
constexpr int POPPY = 1;
const Polygon BED = rectangle({ 30.0f, 30.0f });
constexpr double BED_AREA = 30.0 * 30.0;

/// Grass 60 : poppy 3. Before `paint_it` the map gives the mix everywhere.
PlacementRequest meadow(const std::function<void(DensityMap &)> &paint_it) {
	PlacementRequest request = square_field(SIDE, DENSITY, 2);
	request.species[GRASS].weight = 60.0f;
	request.species[POPPY].weight = 3.0f;
	DensityMap map;
	request.species[GRASS].layer = map.need_layer("Grass");
	request.species[POPPY].layer = map.need_layer("Poppy");
	fill_polygon(map, GRASS, rectangle({ SIDE, SIDE }), 1.0f);
	fill_polygon(map, POPPY, rectangle({ SIDE, SIDE }), 1.0f);
	paint_it(map);
	request.map = std::make_shared<DensityMap>(std::move(map));
	return request;
}

void paint_bed(DensityMap &map, float plants) {
	fill_polygon_plants(map, POPPY, BED, plants);
}

bool is_in_bed(const FieldPlants &plants, int i) {
	const PlacedPlant plant = plants.plant(i);
	return std::abs(plant.root.x) < 15.0f && std::abs(plant.root.z) < 15.0f;
}

int count_in_bed(const FieldPlants &plants, int species) {
	int count = 0;
	for (int i = 0; i < plants.size(); i++) {
		count += static_cast<int>(is_in_bed(plants, i) && plants.plant(i).species == species);
	}
	return count;
}

double density_in_bed(const FieldPlants &plants, int species) {
	return count_in_bed(plants, species) / BED_AREA;
}

std::map<std::pair<float, float>, int> species_beside_bed(const FieldPlants &plants) {
	std::map<std::pair<float, float>, int> found;
	for (int i = 0; i < plants.size(); i++) {
		if (!is_in_bed(plants, i)) {
			found[{ plants.plant(i).root.x, plants.plant(i).root.z }] = plants.plant(i).species;
		}
	}
	return found;
}

} // namespace

TEST_CASE("a species has its painted density and replaces other species") {
	const FieldPlants before = placed(meadow([](DensityMap &) {}));
	for (const float plants : { 0.1f, 1.0f, 5.0f, 11.0f, 12.0f }) {
		const FieldPlants after = placed(meadow([&](DensityMap &map) { paint_bed(map, plants); }));
		CHECK(density_in_bed(after, POPPY) == doctest::Approx(plants).epsilon(0.06));
		CHECK(density_in_bed(after, GRASS) + density_in_bed(after, POPPY) == doctest::Approx(DENSITY).epsilon(0.05));
		CHECK(species_beside_bed(after) == species_beside_bed(before));
	}
}

TEST_CASE("drifts of a species do not change its painted density") {
	for (const float clumping : { 0.5f, 1.0f }) {
		PlacementRequest request = meadow([](DensityMap &map) { paint_bed(map, 5.0f); });
		request.clumping = clumping;
		const FieldPlants plants = placed(request);
		CHECK(density_in_bed(plants, POPPY) == doctest::Approx(5.0).epsilon(0.06));
		CHECK(density_in_bed(plants, GRASS) == doctest::Approx(7.0).epsilon(0.06));
	}
}

TEST_CASE("other species fill a sparsely painted drift") {
	PlacementRequest request = meadow([](DensityMap &map) { paint_bed(map, 1.0f); });
	request.species[POPPY].weight = 60.0f;
	request.clumping = 1.0f;
	const FieldPlants plants = placed(request);
	CHECK(density_in_bed(plants, POPPY) == doctest::Approx(1.0).epsilon(0.1));
	CHECK(density_in_bed(plants, GRASS) > 8.0);
}

TEST_CASE("painted plants use empty positions first") {
	const FieldPlants plants = placed(meadow([](DensityMap &map) {
		fill_polygon(map, GRASS, BED, 0.5f);
		paint_bed(map, 4.0f);
	}));
	CHECK(density_in_bed(plants, POPPY) == doctest::Approx(4.0).epsilon(0.06));
	CHECK(density_in_bed(plants, GRASS) == doctest::Approx(0.5 * DENSITY * 60.0 / 63.0).epsilon(0.06));
}

TEST_CASE("a higher painted density preserves the existing plants of the species") {
	const auto poppies = [](float density) {
		const FieldPlants plants = placed(meadow([&](DensityMap &map) { paint_bed(map, density); }));
		std::set<std::pair<float, float>> found;
		for (int i = 0; i < plants.size(); i++) {
			if (plants.plant(i).species == POPPY) {
				found.insert({ plants.plant(i).root.x, plants.plant(i).root.z });
			}
		}
		return found;
	};
	const auto sparse = poppies(2.0f);
	const auto dense = poppies(6.0f);
	CHECK(std::includes(dense.begin(), dense.end(), sparse.begin(), sparse.end()));
	const FieldPlants mixed = placed(meadow([](DensityMap &) {}));
	int lost = 0;
	for (int i = 0; i < mixed.size(); i++) {
		const PlacedPlant plant = mixed.plant(i);
		lost += static_cast<int>(plant.species == POPPY && dense.count({ plant.root.x, plant.root.z }) == 0);
	}
	CHECK(lost == 0);
}

TEST_CASE("more plants than the field has room for are reduced in proportion") {
	const FieldPlants plants = placed(meadow([](DensityMap &map) {
		fill_polygon_plants(map, GRASS, BED, 18.0f);
		paint_bed(map, 6.0f);
	}));
	CHECK(density_in_bed(plants, GRASS) == doctest::Approx(9.0).epsilon(0.06));
	CHECK(density_in_bed(plants, POPPY) == doctest::Approx(3.0).epsilon(0.06));
}

TEST_CASE("a species without a weight in the mix grows where it is painted") {
	PlacementRequest request = meadow([](DensityMap &map) { paint_bed(map, 3.0f); });
	request.species[POPPY].weight = 0.0f;
	CHECK(density_in_bed(placed(request), POPPY) == doctest::Approx(3.0).epsilon(0.06));
}

TEST_CASE("two entries of one layer share its painted plants") {
	PlacementRequest request = meadow([](DensityMap &map) { paint_bed(map, 6.0f); });
	request.species.push_back(request.species[POPPY]);
	request.species.back().weight = 6.0f;
	const FieldPlants plants = placed(request);
	CHECK(density_in_bed(plants, POPPY) == doctest::Approx(2.0).epsilon(0.08));
	CHECK(density_in_bed(plants, POPPY + 1) == doctest::Approx(4.0).epsilon(0.08));
}

TEST_CASE("painting the mix restores the previous field") {
	const FieldPlants before = placed(meadow([](DensityMap &) {}));
	const FieldPlants after = placed(meadow([](DensityMap &map) {
		paint_bed(map, 5.0f);
		fill_polygon(map, POPPY, BED, 1.0f);
	}));
	CHECK(hash_of(after) == hash_of(before));
}

TEST_CASE("a field with plants/m² in parts has the plants of the whole") {
	const PlacementRequest whole = meadow([](DensityMap &map) {
		const DensityStroke stroke = { DensityStroke::Does::approach_plants, 5.0f, 0.7f };
		paint(map, POPPY, { { 3.0f, -4.0f }, 9.0f, 0.8f }, stroke);
	});
	int count = 0;
	for (int part = 0; part < 9; part++) {
		PlacementRequest request = whole;
		const glm::vec2 low = { static_cast<float>(part % 3) * 20.0f - 30.0f,
			static_cast<float>(part / 3) * 20.0f - 30.0f };
		request.within = AreaBox{ low, low + 20.0f };
		request.map = std::make_shared<DensityMap>(whole.map->cut(whole.map->cells_around(*request.within)));
		count += placed(request).size();
	}
	CHECK(count == placed(whole).size());
}

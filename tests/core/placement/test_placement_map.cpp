#include "placement/density_brush.hpp"
#include "placement/placement.hpp"
#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

using namespace undergrowth;

namespace {

constexpr float SIDE = 40.0f;
constexpr float DENSITY = 20.0f;

/// A square field of two species with a map that has a layer for each.
PlacementRequest painted_field(const std::function<void(DensityMap &)> &paint_it) {
	PlacementRequest request = square_field(SIDE, DENSITY, 2);
	DensityMap map;
	request.species[0].layer = map.need_layer("Poppy");
	request.species[1].layer = map.need_layer("Grass");
	paint_it(map);
	request.map = std::make_shared<DensityMap>(std::move(map));
	return request;
}

PlacementRequest with_area(PlacementRequest request, const Polygon &area) {
	request.area = area;
	return request;
}

void fill_both(DensityMap &map, float density) {
	fill_polygon(map, 0, rectangle({ SIDE, SIDE }), density);
	fill_polygon(map, 1, rectangle({ SIDE, SIDE }), density);
}

int count_of(const FieldPlants &plants, int species) {
	return static_cast<int>(std::count(plants.species.begin(), plants.species.end(), species));
}

} // namespace

TEST_CASE("a fully painted field is the same as one without a map, byte for byte") {
	const PlacementRequest plain = square_field(SIDE, DENSITY, 2);
	const PlacementRequest full = painted_field([](DensityMap &map) { fill_both(map, 1.0f); });
	CHECK(hash_of(placed(full)) == hash_of(placed(plain)));
}

TEST_CASE("nothing grows without paint") {
	CHECK(placed(painted_field([](DensityMap &) {})).size() == 0);
	PlacementRequest request = painted_field([](DensityMap &map) { fill_both(map, 1.0f); });
	request.species[0].layer = -1;
	CHECK(count_of(placed(request), 0) == 0);
	CHECK(count_of(placed(request), 1) > 0);
}

TEST_CASE("the number of plants of each species matches its painted density") {
	const FieldPlants plants = placed(painted_field([](DensityMap &map) {
		fill_polygon(map, 0, rectangle({ SIDE, SIDE }), 0.25f);
		fill_polygon(map, 1, rectangle({ SIDE, SIDE }), 0.75f);
	}));
	const double each = 0.5 * static_cast<double>(SIDE * SIDE * DENSITY);
	// Four standard deviations of a binomial count.
	CHECK(count_of(plants, 0) == doctest::Approx(0.25 * each).epsilon(4.0 * std::sqrt(3.0 / each)));
	CHECK(count_of(plants, 1) == doctest::Approx(0.75 * each).epsilon(4.0 * std::sqrt(1.0 / 3.0 / each)));
}

TEST_CASE("the cell of a plant determines its presence and its height") {
	const PlacementRequest plain = square_field(SIDE, DENSITY, 2);
	const PlacementRequest request = painted_field([](DensityMap &map) {
		paint(map, 0, { { 3.0f, -5.0f }, 6.0f, 0.0f }, { DensityStroke::Does::add, 1.0f, 1.0f });
		paint(map, 0, { { 3.0f, -5.0f }, 3.0f, 0.0f }, { DensityStroke::Does::set_height, 2.0f, 1.0f });
	});
	std::map<std::pair<float, float>, PlacedPlant> all;
	const FieldPlants without = placed(plain);
	for (int i = 0; i < without.size(); i++) {
		const PlacedPlant plant = without.plant(i);
		all[{ plant.root.x, plant.root.z }] = plant;
	}
	const FieldPlants plants = placed(request);
	REQUIRE(plants.size() > 500);
	int high = 0;
	for (int i = 0; i < plants.size(); i++) {
		const PlacedPlant plant = plants.plant(i);
		const DensityCell cell = request.map->cell_at(0, { plant.root.x, plant.root.z });
		CHECK(plant.species == 0);
		CHECK(cell.density == 255);
		const PlacedPlant &was = all.at({ plant.root.x, plant.root.z });
		CHECK(plant.height == doctest::Approx(was.height * cell.height_factor()).epsilon(1e-3));
		CHECK(plant.turn == was.turn);
		high += static_cast<int>(cell.height_factor() == 2.0f);
	}
	CHECK(high > 100);
}

TEST_CASE("painted jitter varies scale and color where it is painted, and nothing else") {
	const PlacementRequest plain = painted_field([](DensityMap &map) { fill_both(map, 1.0f); });
	const auto with = [](DensityStroke::Does does, float jitter) {
		return painted_field([&](DensityMap &map) {
			fill_both(map, 1.0f);
			paint(map, 0, { { 3.0f, -5.0f }, 9.0f, 0.0f }, { does, jitter, 1.0f });
		});
	};
	const FieldPlants before = placed(plain);
	const FieldPlants scaled = placed(with(DensityStroke::Does::set_scale_jitter, 0.5f));
	const FieldPlants colored = placed(with(DensityStroke::Does::set_color_jitter, 0.8f));
	REQUIRE(scaled.size() == before.size());
	REQUIRE(colored.size() == before.size());
	float least = 10.0f, most = 0.0f, darkest = 0.0f, lightest = 0.0f, coldest = 0.0f, warmest = 0.0f;
	int outside = 0;
	for (int i = 0; i < before.size(); i++) {
		const PlacedPlant was = before.plant(i);
		PlacedPlant large = scaled.plant(i);
		PlacedPlant bright = colored.plant(i);
		const glm::vec2 way = glm::vec2(was.root.x, was.root.z) - glm::vec2(3.0f, -5.0f);
		if (was.species != 0 || std::sqrt(way.x * way.x + way.y * way.y) > 10.0f) {
			CHECK(large.scale == was.scale);
			CHECK(bright.lightness == 0.0f);
			CHECK(bright.warmth == 0.0f);
			outside++;
		}
		least = std::min(least, large.scale / was.scale);
		most = std::max(most, large.scale / was.scale);
		darkest = std::min(darkest, bright.lightness);
		lightest = std::max(lightest, bright.lightness);
		coldest = std::min(coldest, bright.warmth);
		warmest = std::max(warmest, bright.warmth);
		CHECK(large.lightness == 0.0f);
		CHECK(bright.scale == was.scale);
		for (const PlacedPlant *plant : { &large, &bright }) {
			REQUIRE(plant->root == was.root);
			REQUIRE(plant->species == was.species);
			REQUIRE(plant->turn == was.turn);
			REQUIRE(plant->height == was.height);
			REQUIRE(plant->variant == was.variant);
		}
	}
	CHECK(outside > before.size() / 2);
	CHECK(least == doctest::Approx(0.5f).epsilon(0.02));
	CHECK(most == doctest::Approx(1.5f).epsilon(0.02));
	for (const float end : { lightest, -darkest, warmest, -coldest }) {
		CHECK(end == doctest::Approx(0.8f).epsilon(0.02));
	}
}

TEST_CASE("a higher density preserves all existing plants") {
	FieldPlants thin = placed(painted_field([](DensityMap &map) { fill_both(map, 0.3f); }));
	FieldPlants dense = placed(painted_field([](DensityMap &map) { fill_both(map, 0.6f); }));
	std::map<std::pair<float, float>, int> there;
	for (int i = 0; i < dense.size(); i++) {
		there[{ dense.plant(i).root.x, dense.plant(i).root.z }] = i;
	}
	for (int i = 0; i < thin.size(); i++) {
		const auto found = there.find({ thin.plant(i).root.x, thin.plant(i).root.z });
		REQUIRE(found != there.end());
		CHECK(dense.plant(found->second).turn == thin.plant(i).turn);
	}
}

TEST_CASE("a painted field in parts, each with a cut of the map, has the plants of the whole") {
	const PlacementRequest whole = painted_field([](DensityMap &map) {
		for (int i = 0; i < 40; i++) {
			const auto n = static_cast<float>(i);
			const glm::vec2 centre = { std::fmod(n * 7.3f, SIDE) - 20.0f, std::fmod(n * 3.1f, SIDE) - 20.0f };
			paint(map, i % 2, { centre, 3.0f, 0.8f }, { DensityStroke::Does::add, 0.7f, 1.0f });
		}
	});
	const FieldPlants all = placed(whole);
	std::map<std::pair<float, float>, int> missing;
	for (int i = 0; i < all.size(); i++) {
		missing[{ all.plant(i).root.x, all.plant(i).root.z }] = i;
	}
	for (int part = 0; part < 16; part++) {
		const glm::vec2 middle = { static_cast<float>(part % 4) * 10.0f - 15.0f,
			static_cast<float>(part / 4) * 10.0f - 15.0f };
		PlacementRequest request = with_area(whole, rectangle({ 10.0f, 10.0f }, middle));
		const CellRange cells = whole.map->cells_around(bounding_box(request.area));
		request.map = std::make_shared<DensityMap>(whole.map->cut(cells));
		const FieldPlants plants = placed(request);
		for (int i = 0; i < plants.size(); i++) {
			CHECK(missing.erase({ plants.plant(i).root.x, plants.plant(i).root.z }) == 1);
		}
	}
	CHECK(missing.empty());
}

TEST_CASE("distant patches are placed without visiting the space between them") {
	PlacementRequest request = painted_field([](DensityMap &map) {
		for (const float at : { -90000.0f, 90000.0f }) {
			paint(map, 0, { { at, at }, 5.0f, 0.0f }, { DensityStroke::Does::add, 1.0f, 1.0f });
		}
	});
	request.area = rectangle({ 200000.0f, 200000.0f });
	const Placement placement(request);
	CHECK(placement.fault() == PlacementFault::none);
	CHECK(placement.candidate_count(0, placement.row_count()) < 50000);
	CHECK(placed(request).size() == doctest::Approx(2.0 * 78.5 * 10.0).epsilon(0.2));
}

TEST_CASE("a painted field has the same plants on every machine") {
	const FieldPlants plants = placed(painted_field([](DensityMap &map) {
		paint(map, 0, { { 2.0f, 3.0f }, 6.0f, 0.9f }, { DensityStroke::Does::add, 0.8f, 1.0f });
		paint(map, 1, { { -4.0f, 1.0f }, 5.0f, 0.9f }, { DensityStroke::Does::approach, 0.6f, 0.7f });
		paint(map, 1, { { -4.0f, 1.0f }, 3.0f, 0.5f }, { DensityStroke::Does::set_height, 0.5f, 1.0f });
	}));
	CHECK(plants.size() == 436);
	CHECK(hash_of(plants) == 17119375764628116520ull);
}

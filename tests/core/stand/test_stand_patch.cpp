#include "stand/density_brush.hpp"
#include "stand/stand_patch.hpp"
#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <map>

using namespace undergrowth;

namespace {

constexpr float SIDE = 60.0f;

struct Painted {
	PlacementRequest request = square_field(SIDE, 6.0f, 2);
	DensityMap map;
	PlantStore store;

	Painted() {
		request.species[0].layer = map.need_layer("Poppy");
		request.species[1].layer = map.need_layer("Grass");
		fill_polygon(map, 0, rectangle({ SIDE, 0.5f * SIDE }), 0.7f);
		fill();
	}

	PlacementRequest of(const Polygon &area) const {
		PlacementRequest part = request;
		part.area = area;
		part.map = std::make_shared<DensityMap>(map.cut(map.cells_around(bounding_box(area))));
		return part;
	}

	void fill() {
		const PlacementRequest all = of(rectangle({ 2.0f * SIDE, 2.0f * SIDE }));
		StandEdit edit;
		edit.fills = true;
		edit.filled = cut_into_blocks(placed(all), edit.tile_size);
		edit.spacing = Placement(all).cell_size();
		store.apply(std::move(edit));
	}

	/// Updates the plants in the cells to the painted map, on ground that ends at `edge` (m, x).
	ChangeSet patch(const CellRange &cells, float edge = 1.0e9f) {
		const AreaBox box = map.box_of(cells);
		StandPatch patch(store.filled_in(box), store.spacing());
		FieldPlants newcomers =
				patch.find_newcomers(placed(of(rectangle(box.high - box.low, 0.5f * (box.low + box.high)))));
		std::vector<float> heights;
		for (const float x : newcomers.x) {
			heights.push_back(x < edge ? 0.0f : std::numeric_limits<float>::quiet_NaN());
		}
		apply_ground(newcomers, heights.data(), nullptr, {});
		return store.apply(patch.make_edit(newcomers));
	}

	std::map<PlantId, uint64_t> plants() const {
		std::map<PlantId, uint64_t> found;
		for (const PlantId id : store.ids()) {
			const PlantPlace place = store.find(id);
			FieldPlants alone;
			alone.add(store.block(place.block).plants.plant(place.slot));
			found[id] = hash_of(alone);
		}
		return found;
	}
};

DensityStroke stroke_of(int number) {
	const auto kind = static_cast<DensityStroke::Does>(number % 4);
	return { kind, kind == DensityStroke::Does::add && number % 8 >= 4 ? -0.8f : 0.9f, 0.8f };
}

} // namespace

TEST_CASE("many strokes give the same plants as one build of the field") {
	Painted field;
	for (int i = 0; i < 120; i++) {
		const auto n = static_cast<float>(i);
		const glm::vec2 centre = { std::fmod(n * 17.3f, SIDE) - 30.0f, std::fmod(n * 7.1f, SIDE) - 30.0f };
		const CellRange cells = paint(field.map, (i / 3) % 2, { centre, 4.0f, 0.6f }, stroke_of(i));
		if (!cells.is_empty()) {
			field.patch(cells);
		}
	}
	const std::map<PlantId, uint64_t> edited = field.plants();
	CHECK(edited.size() > 2000);
	CHECK(static_cast<int>(edited.size()) == field.store.plant_count());
	field.fill();
	CHECK(edited == field.plants());
}

TEST_CASE("an unchanged patch does nothing, also with late plants") {
	Painted field;
	const CellRange cells =
			paint(field.map, 1, { { 3.0f, 22.0f }, 5.0f, 0.5f }, { DensityStroke::Does::add, 1.0f, 1.0f });
	CHECK(!field.patch(cells).grown.empty());
	for (int i = 0; i < 2; i++) {
		const ChangeSet again = field.patch(cells);
		CHECK(again.grown.empty());
		CHECK(again.gone.empty());
		CHECK(again.dropped.empty());
		CHECK(again.moved.empty());
	}
}

TEST_CASE("plants outside of a stroke, and unchanged ones in it, preserve their locations") {
	Painted field;
	std::map<PlantId, PlantPlace> before;
	for (const PlantId id : field.store.ids()) {
		before[id] = field.store.find(id);
	}
	field.patch(paint(field.map, 0, { { 0.0f, 0.0f }, 6.0f, 0.5f }, { DensityStroke::Does::add, -0.5f, 1.0f }));
	field.patch(paint(field.map, 1, { { 0.0f, 0.0f }, 6.0f, 0.5f }, { DensityStroke::Does::add, 1.0f, 1.0f }));
	int stayed = 0;
	for (const auto &[id, place] : before) {
		const PlantPlace now = field.store.find(id);
		stayed += static_cast<int>(now == place);
		CHECK((now == place || now.block < 0));
	}
	CHECK(stayed > 3000);
	CHECK(stayed < static_cast<int>(before.size()));
}

TEST_CASE("a plant that becomes higher preserves its id, and its motion is transferred") {
	Painted field;
	const std::map<PlantId, uint64_t> before = field.plants();
	const ChangeSet changes = field.patch(
			paint(field.map, 0, { { 0.0f, 0.0f }, 4.0f, 0.0f }, { DensityStroke::Does::set_height, 2.0f, 1.0f }));
	const std::map<PlantId, uint64_t> after = field.plants();
	CHECK(changes.moved.size() > 80);
	CHECK(changes.moved.size() == changes.gone.size());
	CHECK(after.size() == before.size());
	for (const ChangeSet::Moved &plant : changes.moved) {
		const PlantBlock &now = field.store.block(plant.to.block);
		const PlantBlock &was = field.store.block(plant.from.block);
		CHECK(now.is_late);
		CHECK(was.is_gone(plant.from.slot));
		CHECK(now.root(plant.to.slot) == was.root(plant.from.slot));
		CHECK(before.count(field.store.id(plant.to)) == 1);
	}
}

TEST_CASE("the ground's limits reject late plants and remove changed ones") {
	Painted field;
	const DensityStroke higher = { DensityStroke::Does::set_height, 2.0f, 1.0f };
	const ChangeSet changes = field.patch(paint(field.map, 0, { { 0.0f, 0.0f }, 4.0f, 0.0f }, higher), 0.0f);
	CHECK(!changes.moved.empty());
	CHECK(changes.gone.size() > changes.moved.size() + 20);
	for (const ChangeSet::Moved &plant : changes.moved) {
		CHECK(field.store.block(plant.to.block).root(plant.to.slot).x < 0.0f);
	}
}

TEST_CASE("empty blocks of late plants are dropped and do not accumulate") {
	Painted field;
	const int blocks = field.store.block_count();
	const int plants = field.store.plant_count();
	for (int i = 0; i < 60; i++) {
		const float amount = i % 2 == 0 ? 1.0f : -1.0f;
		field.patch(paint(field.map, 1, { { 5.0f, 5.0f }, 9.0f, 0.0f }, { DensityStroke::Does::add, amount, 1.0f }));
	}
	CHECK(field.store.plant_count() == plants);
	CHECK(field.store.block_count() <= blocks + 8);
}

TEST_CASE("late plants of a tile are in blocks of a thousand") {
	Painted field;
	field.request.density = 400.0f;
	field.map.clear();
	field.map.need_layer("Poppy");
	field.map.need_layer("Grass");
	field.fill();
	field.patch(paint(field.map, 1, { { 8.0f, 8.0f }, 7.0f, 0.0f }, { DensityStroke::Does::add, 1.0f, 1.0f }));
	CHECK(field.store.plant_count() > 20000);
	for (int number = 0; number < field.store.block_count(); number++) {
		CHECK(field.store.block(number).size() <= PlantBlock::MOST_NEWCOMERS);
	}
}

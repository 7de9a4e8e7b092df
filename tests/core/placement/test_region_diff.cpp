#include "placement/density_brush.hpp"
#include "placement/region_diff.hpp"
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
		StoreEdit edit;
		edit.replaces_all = true;
		edit.generated = cut_into_chunks(placed(all), edit.tile_size);
		edit.spacing = Placement(all).cell_size();
		store.apply(std::move(edit));
	}

	/// Updates the plants in the cells to the painted map, on ground that ends at `edge` (m, x).
	ChangeSet update(const CellRange &cells, float edge = 1.0e9f) {
		const AreaBox box = map.box_of(cells);
		RegionDiff update(store.generated_in(box), store.spacing());
		FieldPlants new_plants =
				update.find_new_plants(placed(of(rectangle(box.high - box.low, 0.5f * (box.low + box.high)))));
		std::vector<float> heights;
		for (const float x : new_plants.x) {
			heights.push_back(x < edge ? 0.0f : std::numeric_limits<float>::quiet_NaN());
		}
		apply_ground(new_plants, heights.data(), nullptr, {});
		return store.apply(update.make_edit(new_plants));
	}

	std::map<PlantId, uint64_t> plants() const {
		std::map<PlantId, uint64_t> found;
		for (const PlantId id : store.ids()) {
			const PlantRef place = store.find(id);
			FieldPlants alone;
			alone.add(store.chunk(place.chunk).plants.plant(place.slot));
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
			field.update(cells);
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
	CHECK(!field.update(cells).grown.empty());
	for (int i = 0; i < 2; i++) {
		const ChangeSet again = field.update(cells);
		CHECK(again.grown.empty());
		CHECK(again.gone.empty());
		CHECK(again.dropped.empty());
		CHECK(again.moved.empty());
	}
}

TEST_CASE("plants outside of a stroke, and unchanged ones in it, preserve their locations") {
	Painted field;
	std::map<PlantId, PlantRef> before;
	for (const PlantId id : field.store.ids()) {
		before[id] = field.store.find(id);
	}
	field.update(paint(field.map, 0, { { 0.0f, 0.0f }, 6.0f, 0.5f }, { DensityStroke::Does::add, -0.5f, 1.0f }));
	field.update(paint(field.map, 1, { { 0.0f, 0.0f }, 6.0f, 0.5f }, { DensityStroke::Does::add, 1.0f, 1.0f }));
	int stayed = 0;
	for (const auto &[id, place] : before) {
		const PlantRef now = field.store.find(id);
		stayed += static_cast<int>(now == place);
		CHECK((now == place || now.chunk < 0));
	}
	CHECK(stayed > 3000);
	CHECK(stayed < static_cast<int>(before.size()));
}

TEST_CASE("a plant that becomes higher preserves its id, and its motion is transferred") {
	Painted field;
	const std::map<PlantId, uint64_t> before = field.plants();
	const ChangeSet changes = field.update(
			paint(field.map, 0, { { 0.0f, 0.0f }, 4.0f, 0.0f }, { DensityStroke::Does::set_height, 2.0f, 1.0f }));
	const std::map<PlantId, uint64_t> after = field.plants();
	CHECK(changes.moved.size() > 80);
	CHECK(changes.moved.size() == changes.gone.size());
	CHECK(after.size() == before.size());
	for (const ChangeSet::Moved &plant : changes.moved) {
		const PlantChunk &now = field.store.chunk(plant.to.chunk);
		const PlantChunk &was = field.store.chunk(plant.from.chunk);
		CHECK(now.is_new);
		CHECK(was.is_gone(plant.from.slot));
		CHECK(now.root(plant.to.slot) == was.root(plant.from.slot));
		CHECK(before.count(field.store.id(plant.to)) == 1);
	}
}

TEST_CASE("a plant that becomes larger is replaced and preserves its id") {
	Painted field;
	field.request.species[0].min_scale = field.request.species[0].max_scale = 2.0f;
	const std::size_t count = field.plants().size();
	const ChangeSet changes = field.update(field.map.cells_around({ { -4.0f, 5.0f }, { 4.0f, 13.0f } }));
	CHECK(changes.moved.size() > 50);
	for (const ChangeSet::Moved &plant : changes.moved) {
		CHECK(field.store.chunk(plant.to.chunk).plants.plant(plant.to.slot).scale == 2.0f);
	}
	CHECK(field.plants().size() == count);
}

TEST_CASE("the ground's limits reject late plants and remove changed ones") {
	Painted field;
	const DensityStroke higher = { DensityStroke::Does::set_height, 2.0f, 1.0f };
	const ChangeSet changes = field.update(paint(field.map, 0, { { 0.0f, 0.0f }, 4.0f, 0.0f }, higher), 0.0f);
	CHECK(!changes.moved.empty());
	CHECK(changes.gone.size() > changes.moved.size() + 20);
	for (const ChangeSet::Moved &plant : changes.moved) {
		CHECK(field.store.chunk(plant.to.chunk).root(plant.to.slot).x < 0.0f);
	}
}

TEST_CASE("empty blocks of late plants are dropped and do not accumulate") {
	Painted field;
	const int chunks = field.store.chunk_count();
	const int plants = field.store.plant_count();
	for (int i = 0; i < 60; i++) {
		const float amount = i % 2 == 0 ? 1.0f : -1.0f;
		field.update(paint(field.map, 1, { { 5.0f, 5.0f }, 9.0f, 0.0f }, { DensityStroke::Does::add, amount, 1.0f }));
	}
	CHECK(field.store.plant_count() == plants);
	CHECK(field.store.chunk_count() <= chunks + 8);
}

TEST_CASE("late plants of a tile are in blocks of a thousand") {
	Painted field;
	field.request.density = 400.0f;
	field.map.clear();
	field.map.need_layer("Poppy");
	field.map.need_layer("Grass");
	field.fill();
	field.update(paint(field.map, 1, { { 8.0f, 8.0f }, 7.0f, 0.0f }, { DensityStroke::Does::add, 1.0f, 1.0f }));
	CHECK(field.store.plant_count() > 20000);
	for (int number = 0; number < field.store.chunk_count(); number++) {
		CHECK(field.store.chunk(number).size() <= PlantChunk::MAX_NEW_PLANTS);
	}
}

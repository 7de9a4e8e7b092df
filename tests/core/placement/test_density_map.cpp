#include "placement/density_map.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>

using namespace undergrowth;

namespace {

constexpr DensityCell HALF = { 128, 32 };

} // namespace

TEST_CASE("a new map is empty and reports nothing painted") {
	DensityMap map;
	const int layer = map.need_layer("Poppy");
	CHECK(map.cell(layer, 3, -7) == DensityCell());
	CHECK(map.cell(layer, 3, -7).share() == 0.0f);
	CHECK(map.cell(layer, 3, -7).height_factor() == 1.0f);
	CHECK(map.painted().is_empty());
	CHECK(map.block_count() == 0);
}

TEST_CASE("cell sizes are clamped") {
	CHECK(DensityMap(0.1f).cell_size() == 0.25f);
	CHECK(DensityMap(3.0f).cell_size() == 2.0f);
	CHECK(DensityMap(1.0f).cell_size() == 1.0f);
	CHECK(DensityMap(std::numeric_limits<float>::quiet_NaN()).cell_size() == 0.5f);
}

TEST_CASE("cells are stored on all sides of the origin, in blocks that exist only where painted") {
	DensityMap map;
	const int layer = map.need_layer("Poppy");
	for (const int column : { -33, -32, -1, 0, 31, 32, 199999 }) {
		for (const int row : { -200000, -1, 0, 5 }) {
			map.set_cell(layer, column, row, HALF);
			CHECK(map.cell(layer, column, row) == HALF);
		}
	}
	CHECK(map.cell(layer, -34, 0) == DensityCell());
	CHECK(map.cell(layer, 1, 0) == DensityCell());
	CHECK(map.block_count() == 5 * 3);
}

TEST_CASE("a position is in the cell that begins below it") {
	DensityMap map(0.5f);
	const int layer = map.need_layer("Poppy");
	map.set_cell(layer, -1, 2, HALF);
	CHECK(map.cell_at(layer, { -0.5f, 1.0f }) == HALF);
	CHECK(map.cell_at(layer, { -0.001f, 1.49f }) == HALF);
	CHECK(map.cell_at(layer, { 0.0f, 1.0f }) == DensityCell());
	CHECK(map.cell_at(layer, { -0.1f, 1.5f }) == DensityCell());
	CHECK(map.middle_of(-1, 2) == glm::vec2(-0.25f, 1.25f));
}

TEST_CASE("layers are found by their names and need one") {
	DensityMap map;
	CHECK(map.need_layer("Poppy") == 0);
	CHECK(map.need_layer("Grass") == 1);
	CHECK(map.need_layer("Poppy") == 0);
	CHECK(map.find_layer("Fern") == -1);
	CHECK(map.need_layer("") == -1);
	CHECK(map.need_layer(std::string(256, 'a')) == -1);
	map.set_cell(1, 4, 4, HALF);
	map.remove_layer(0);
	CHECK(map.find_layer("Grass") == 0);
	CHECK(map.cell(0, 4, 4) == HALF);
}

TEST_CASE("a map has at most 256 layers") {
	DensityMap map;
	for (int i = 0; i < DensityMap::MAX_LAYERS; i++) {
		REQUIRE(map.need_layer(std::to_string(i)) == i);
	}
	CHECK(map.need_layer("one more") == -1);
	CHECK(map.need_layer("7") == 7);
}

TEST_CASE("a shared copy does not change with the map") {
	DensityMap map;
	const int layer = map.need_layer("Poppy");
	map.set_cell(layer, 0, 0, HALF);
	const DensityMap before = map.share();
	const DensityMap part = map.cut({ 0, 0, 1, 1 });
	map.set_cell(layer, 0, 0, { 255, 64 });
	map.set_cell(layer, 1, 0, { 1, 64 });
	CHECK(before.cell(layer, 0, 0) == HALF);
	CHECK(part.cell(layer, 0, 0) == HALF);
	CHECK(part.cell(layer, 1, 0) == DensityCell());
	CHECK(map.cell(layer, 0, 0).density == 255);
	const DensityMap again = map.share();
	map.set_cell(layer, 0, 0, {});
	CHECK(again.cell(layer, 0, 0).density == 255);
}

TEST_CASE("a cut has all layers, with the blocks that meet it") {
	DensityMap map;
	map.need_layer("Poppy");
	map.need_layer("Grass");
	for (int i = -3; i <= 3; i++) {
		map.set_cell(1, 32 * i, 0, HALF);
	}
	const DensityMap part = map.cut({ -1, 0, 32, 5 });
	CHECK(part.layer_count() == 2);
	CHECK(part.layer_name(1) == "Grass");
	CHECK(part.block_count() == 3);
	CHECK(part.cell(1, 32, 0) == HALF);
	CHECK(part.cell(1, 64, 0) == DensityCell());
	CHECK(map.cut({}).block_count() == 0);
}

TEST_CASE("empty blocks are freed on request") {
	DensityMap map;
	const int layer = map.need_layer("Poppy");
	map.set_cell(layer, 0, 0, HALF);
	map.set_cell(layer, 100, 0, HALF);
	map.set_cell(layer, 0, 0, {});
	map.set_cell(layer, 100, 0, {});
	map.tidy(layer, { 0, 0, 5, 5 });
	CHECK(map.block_count() == 1);
	map.tidy(layer, { 0, 0, 100, 0 });
	CHECK(map.block_count() == 0);
	map.set_cell(layer, 0, 0, HALF);
	CHECK(map.cell(layer, 0, 0) == HALF);
}

TEST_CASE("cells around a box are those that it touches, within the coordinate limits") {
	const DensityMap map(0.5f);
	CHECK(map.cells_around({ { -0.1f, 0.0f }, { 0.6f, 0.4f } }) == CellRange{ -1, 0, 1, 0 });
	CHECK(map.cells_around({ { 0.6f, 0.0f }, { 0.1f, 0.4f } }).is_empty());
	CHECK(map.cells_around({ { 2.0e5f, 0.0f }, { 3.0e5f, 0.0f } }).is_empty());
	const float nan = std::numeric_limits<float>::quiet_NaN();
	CHECK(map.cells_around({ { nan, 0.0f }, { 1.0f, 1.0f } }).is_empty());
	const CellRange far = map.cells_around({ { 99999.9f, 0.0f }, { 3.0e38f, 0.0f } });
	CHECK(far == CellRange{ 199999, 0, 200000, 0 });
	const AreaBox box = map.box_of({ -1, 0, 1, 0 });
	CHECK(box.low == glm::vec2(-0.5f, 0.0f));
	CHECK(box.high == glm::vec2(1.0f, 0.5f));
}

TEST_CASE("cells are copied from another map by layer names") {
	DensityMap map;
	DensityMap other;
	map.need_layer("Poppy");
	map.need_layer("Grass");
	other.need_layer("Grass");
	other.need_layer("Fern");
	for (int i = 0; i < 10; i++) {
		map.set_cell(0, i, 0, HALF);
		map.set_cell(1, i, 0, HALF);
		other.set_cell(0, i, 0, { 7, 64 });
		other.set_cell(1, i, 0, { 9, 64 });
	}
	CHECK(map.take(other, { 2, -3, 4, 5 }) == CellRange{ 2, 0, 4, 0 });
	CHECK(map.take(other, { 2, -3, 4, 5 }).is_empty());
	CHECK(map.layer_count() == 3);
	CHECK(map.cell(0, 2, 0) == DensityCell());
	CHECK(map.cell(1, 4, 0).density == 7);
	CHECK(map.cell(2, 3, 0).density == 9);
	CHECK(map.cell(0, 5, 0) == HALF);
	CHECK(map.cell(1, 1, 0) == HALF);
	CHECK(map.cell(2, 5, 0) == DensityCell());
}

TEST_CASE("all cells of a range are copied, the last row and column included, and no other cells") {
	DensityMap map;
	DensityMap other;
	other.need_layer("Grass");
	for (int row = -4; row < 4; row++) {
		for (int column = -4; column < 4; column++) {
			other.set_cell(0, column, row, HALF);
		}
	}
	const CellRange taken = { -2, -3, 1, 2 };
	CHECK(map.take(other, taken) == taken);
	for (int row = -4; row < 4; row++) {
		for (int column = -4; column < 4; column++) {
			const bool is_inside = column >= -2 && column <= 1 && row >= -3 && row <= 2;
			CHECK(map.cell(0, column, row) == (is_inside ? HALF : DensityCell()));
		}
	}
}

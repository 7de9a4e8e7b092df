#include "placement/density_brush.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

using namespace undergrowth;

namespace {

constexpr double PI = 3.14159265358979;
const CellRange AROUND = { -40, -40, 40, 40 };

DensityBrush hard(float radius, glm::vec2 centre = { 0.0f, 0.0f }) {
	return { centre, radius, 0.0f };
}

double painted_area(const DensityMap &map, int layer) {
	double sum = 0.0;
	for (int row = AROUND.first_row; row <= AROUND.last_row; row++) {
		for (int column = AROUND.first_column; column <= AROUND.last_column; column++) {
			sum += static_cast<double>(map.cell(layer, column, row).share());
		}
	}
	return sum * static_cast<double>(map.cell_size()) * static_cast<double>(map.cell_size());
}

} // namespace

TEST_CASE("a hard brush paints a disc and reports the changed cells") {
	DensityMap map(0.25f);
	const int layer = map.need_layer("Poppy");
	const CellRange changed = paint(map, layer, hard(3.0f), { DensityStroke::Does::add, 1.0f, 1.0f });
	CHECK(changed == CellRange{ -12, -12, 11, 11 });
	CHECK(painted_area(map, layer) == doctest::Approx(9.0 * PI).epsilon(0.02));
	CHECK(map.cell_at(layer, { 2.9f, 0.0f }).density == 255);
	CHECK(map.cell_at(layer, { 3.1f, 0.0f }).density == 0);
	CHECK(paint(map, layer, hard(3.0f), { DensityStroke::Does::add, 1.0f, 1.0f }).is_empty());
}

TEST_CASE("a soft brush weakens towards its edge and has full strength at its centre") {
	const DensityBrush brush = { { 0.0f, 0.0f }, 4.0f, 0.5f };
	CHECK(brush.weight(0.0f) == 1.0f);
	CHECK(brush.weight(1.99f) == 1.0f);
	CHECK(brush.weight(3.0f) == doctest::Approx(0.5f));
	CHECK(brush.weight(3.5f) < brush.weight(3.0f));
	CHECK(brush.weight(4.0f) == 0.0f);
	CHECK(brush.weight(5.0f) == 0.0f);
	CHECK(hard(4.0f).weight(3.999f) == 1.0f);
}

TEST_CASE("adding and subtracting end at the limits") {
	DensityMap map;
	const int layer = map.need_layer("Poppy");
	const DensityStroke more = { DensityStroke::Does::add, 0.4f, 1.0f };
	paint(map, layer, hard(1.0f), more);
	CHECK(map.cell(layer, 0, 0).density == 102);
	paint(map, layer, hard(1.0f), more);
	paint(map, layer, hard(1.0f), more);
	CHECK(map.cell(layer, 0, 0).density == 255);
	paint(map, layer, hard(1.0f), { DensityStroke::Does::add, -0.6f, 1.0f });
	CHECK(map.cell(layer, 0, 0).density == 102);
	paint(map, layer, hard(1.0f), { DensityStroke::Does::add, -1.0f, 1.0f });
	CHECK(map.cell(layer, 0, 0).density == 0);
	CHECK(map.block_count() == 0);
}

TEST_CASE("a repeated weak stroke reaches its density, from above and from below") {
	DensityMap map;
	const int layer = map.need_layer("Poppy");
	for (const float target : { 0.5f, 0.9f, 0.2f, 0.0f }) {
		int strokes = 0;
		const DensityStroke stroke = { DensityStroke::Does::approach, target, 0.1f };
		while (!paint(map, layer, hard(1.0f), stroke).is_empty() && strokes < 200) {
			strokes++;
		}
		CHECK(strokes > 5);
		CHECK(strokes < 200);
		CHECK(std::abs(map.cell(layer, 0, 0).density - density_code(target)) <= 1);
	}
}

TEST_CASE("heights reach their value, and density is unchanged") {
	DensityMap map;
	const int layer = map.need_layer("Poppy");
	paint(map, layer, hard(1.0f), { DensityStroke::Does::add, 0.5f, 1.0f });
	paint(map, layer, hard(1.0f), { DensityStroke::Does::set_height, 1.5f, 1.0f });
	CHECK(map.cell(layer, 0, 0).height_factor() == 1.5f);
	CHECK(map.cell(layer, 0, 0).density == 128);
	paint(map, layer, hard(1.0f), { DensityStroke::Does::set_height, 0.0f, 1.0f });
	CHECK(map.cell(layer, 0, 0).height_factor() == 0.0625f);
	paint(map, layer, hard(1.0f), { DensityStroke::Does::set_height, 100.0f, 1.0f });
	CHECK(map.cell(layer, 0, 0).height_factor() == doctest::Approx(255.0f / 64.0f));
}

TEST_CASE("jitter of scale and color reaches its value, and all other values stay") {
	DensityMap map;
	const int layer = map.need_layer("Poppy");
	const DensityBrush disc = { { 0.0f, 0.0f }, 3.0f, 0.0f };
	paint(map, layer, disc, { DensityStroke::Does::approach_plants, 7.0f, 1.0f });
	paint(map, layer, disc, { DensityStroke::Does::set_height, 1.5f, 1.0f });
	const DensityCell before = map.cell(layer, 0, 0);
	paint(map, layer, disc, { DensityStroke::Does::set_scale_jitter, 0.4f, 0.5f });
	CHECK(map.cell(layer, 0, 0).scale_range() == doctest::Approx(0.2f).epsilon(0.02));
	paint(map, layer, disc, { DensityStroke::Does::set_scale_jitter, 1.0f, 1.0f });
	CHECK(map.cell(layer, 0, 0).scale_range() <= DensityCell::MAX_SCALE_JITTER + 1.0f / 255.0f);
	const CellRange changed = paint(map, layer, disc, { DensityStroke::Does::set_color_jitter, 0.6f, 1.0f });
	CHECK(!changed.is_empty());
	DensityCell now = map.cell(layer, 0, 0);
	CHECK(now.color_range() == doctest::Approx(0.6f).epsilon(0.02));
	paint(map, layer, { { 3.0f, 0.0f }, 2.0f, 0.0f }, { DensityStroke::Does::smooth, 0.0f, 1.0f });
	const float edge = map.cell(layer, 5, 0).color_range();
	CHECK(edge > 0.05f);
	CHECK(edge < 0.55f);
	fill_polygon(map, layer, rectangle({ 2.0f, 2.0f }), 0.5f);
	CHECK(map.cell(layer, 0, 0).color_jitter == now.color_jitter);
	paint(map, layer, disc, { DensityStroke::Does::approach_plants, 7.0f, 1.0f });
	now.scale_jitter = 0;
	now.color_jitter = 0;
	CHECK(now == before);
}

TEST_CASE("smoothing makes neighbours equal and preserves the total") {
	DensityMap map;
	const int layer = map.need_layer("Poppy");
	paint(map, layer, hard(2.0f), { DensityStroke::Does::add, 1.0f, 1.0f });
	const double before = painted_area(map, layer);
	const int edge = map.cell(layer, 3, 0).density - map.cell(layer, 4, 0).density;
	for (int i = 0; i < 4; i++) {
		paint(map, layer, hard(6.0f), { DensityStroke::Does::smooth, 0.0f, 1.0f });
	}
	CHECK(edge == 255);
	CHECK(map.cell(layer, 3, 0).density - map.cell(layer, 4, 0).density < edge / 3);
	CHECK(painted_area(map, layer) == doctest::Approx(before).epsilon(0.02));
	for (int i = 0; i < 6; i++) { // The same to all sides.
		CHECK(map.cell(layer, 0, i).density == map.cell(layer, i, 0).density);
		CHECK(map.cell(layer, 0, -1 - i).density == map.cell(layer, 0, i).density);
		CHECK(map.cell(layer, -1 - i, 0).density == map.cell(layer, i, 0).density);
	}
}

TEST_CASE("a polygon fills the cells with centres in it") {
	DensityMap map;
	const int layer = map.need_layer("Poppy");
	const CellRange changed = fill_polygon(map, layer, rectangle({ 4.0f, 2.0f }), 0.5f);
	CHECK(changed == CellRange{ -4, -2, 3, 1 });
	CHECK(painted_area(map, layer) == doctest::Approx(8.0 * 128.0 / 255.0));
	fill_polygon(map, layer, rectangle({ 10.0f, 10.0f }), 0.0f);
	CHECK(map.block_count() == 0);
}

TEST_CASE("invalid brushes are detected") {
	const float nan = std::numeric_limits<float>::quiet_NaN();
	CHECK(is_valid(hard(3.0f)));
	CHECK(!is_valid(hard(0.0f)));
	CHECK(!is_valid(hard(101.0f)));
	CHECK(!is_valid(hard(nan)));
	CHECK(!is_valid(hard(1.0f, { nan, 0.0f })));
	CHECK(!is_valid(hard(1.0f, { 0.0f, 1.0e6f })));
	CHECK(!is_valid({ { 0.0f, 0.0f }, 1.0f, -0.1f }));
	CHECK(!is_valid({ { 0.0f, 0.0f }, 1.0f, nan }));
}

TEST_CASE("a brush at the coordinate limits paints its part within them") {
	DensityMap map;
	const int layer = map.need_layer("Poppy");
	const CellRange changed =
			paint(map, layer, hard(2.0f, { FARTHEST_COORDINATE, 0.0f }), { DensityStroke::Does::add, 1.0f, 1.0f });
	CHECK(changed.last_column == 200000);
	CHECK(map.cell_at(layer, { FARTHEST_COORDINATE - 1.0f, 0.0f }).density == 255);
}

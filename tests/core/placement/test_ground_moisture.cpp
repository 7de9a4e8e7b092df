#include "placement/ground_moisture.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace undergrowth;

namespace {

constexpr float NO_GROUND = std::numeric_limits<float>::quiet_NaN();

/// A grid around the origin with the heights of a function of x and z (m).
template <class Height> HeightGrid grid_of(int columns, int rows, float step, Height height) {
	HeightGrid grid;
	grid.step = step;
	grid.columns = columns;
	grid.rows = rows;
	grid.low = { -0.5f * step * static_cast<float>(columns - 1), -0.5f * step * static_cast<float>(rows - 1) };
	grid.heights.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
	for (std::size_t i = 0; i < grid.size(); i++) {
		const glm::vec2 point = grid.point(i);
		grid.heights[i] = static_cast<float>(height(static_cast<double>(point.x), static_cast<double>(point.y)));
	}
	return grid;
}

double column_sum(const HeightGrid &grid, const std::vector<double> &areas, int column) {
	double sum = 0.0;
	for (int row = 0; row < grid.rows; row++) {
		sum += areas[grid.index(column, row)];
	}
	return sum;
}

/// Water that leaves at the border of a square grid: there, and lower than its neighbours along the border.
template <class Height> double drained_at_rim(int side, Height height) {
	const HeightGrid grid = grid_of(side, side, 1.0f, height);
	const std::vector<double> areas = find_drained_areas(grid);
	std::vector<std::size_t> rim;
	for (int i = 0; i < side - 1; i++) {
		rim.push_back(grid.index(i, 0));
	}
	for (int i = 0; i < side - 1; i++) {
		rim.push_back(grid.index(side - 1, i));
	}
	for (int i = side - 1; i > 0; i--) {
		rim.push_back(grid.index(i, side - 1));
	}
	for (int i = side - 1; i > 0; i--) {
		rim.push_back(grid.index(0, i));
	}
	double sum = 0.0;
	for (std::size_t i = 0; i < rim.size(); i++) {
		const float own = grid.heights[rim[i]];
		const float before = grid.heights[rim[(i + rim.size() - 1) % rim.size()]];
		sum += own <= before && own <= grid.heights[rim[(i + 1) % rim.size()]] ? areas[rim[i]] : 0.0;
	}
	return sum;
}

} // namespace

TEST_CASE("on a plane the drained area grows evenly downhill") {
	const HeightGrid grid = grid_of(40, 101, 2.0f, [](double x, double) { return -0.1 * x; });
	const std::vector<double> areas = find_drained_areas(grid);
	for (int column = 0; column < grid.columns; column++) {
		CHECK(column_sum(grid, areas, column) == doctest::Approx(4.0 * 101 * (column + 1)));
		CHECK(areas[grid.index(column, 50)] == doctest::Approx(4.0 * (column + 1)));
	}
	const HabitatRaster moisture = find_moisture(grid);
	for (const int column : { 5, 20, 38 }) {
		const glm::vec2 point = grid.point(grid.index(column, 50));
		CHECK(moisture.at(point) == doctest::Approx(std::log(2.0 * (column + 1) / 0.1) / 10.0));
	}
}

TEST_CASE("a valley collects the water of both sides") {
	const HeightGrid grid = grid_of(61, 41, 1.0f, [](double x, double z) { return 0.2 * std::abs(z) - 0.01 * x; });
	const std::vector<double> areas = find_drained_areas(grid);
	for (const int column : { 20, 40, 59 }) {
		const double upslope = 41.0 * (column + 1);
		const double channel = areas[grid.index(column, 20)];
		CHECK(channel < 1.01 * upslope);
		CHECK(channel > 0.93 * upslope);
		CHECK(areas[grid.index(column, 0)] < 2.0);
	}
	const HabitatRaster moisture = find_moisture(grid);
	CHECK(moisture.at({ 10.0f, 0.0f }) == 1.0f);
	CHECK(moisture.at({ 10.0f, 18.0f }) < 0.35f);
}

TEST_CASE("water of a cone spreads: the drained area per width is half of the radius") {
	const HeightGrid grid = grid_of(121, 121, 0.5f, [](double x, double z) { return -0.3 * std::sqrt(x * x + z * z); });
	const std::vector<double> areas = find_drained_areas(grid);
	for (const double radius : { 8.0, 16.0, 24.0 }) {
		double sum = 0.0;
		int count = 0;
		for (std::size_t i = 0; i < grid.size(); i++) {
			const glm::vec2 point = grid.point(i);
			if (std::abs(static_cast<double>(std::sqrt(point.x * point.x + point.y * point.y)) - radius) < 0.5) {
				sum += areas[i] / 0.5;
				count++;
			}
		}
		CHECK(sum / count == doctest::Approx(0.5 * radius).epsilon(0.08));
	}
}

TEST_CASE("all water leaves the grid, out of pits too") {
	CHECK(drained_at_rim(31, [](double x, double z) { return -0.01 * (x * x + z * z); }) == doctest::Approx(961.0));
	CHECK(drained_at_rim(31, [](double x, double z) { return 0.01 * (x * x + z * z); }) == doctest::Approx(961.0));
}

TEST_CASE("pits are wet up to their outlet, and crests dry") {
	const HeightGrid grid = grid_of(61, 61, 1.0f, [](double x, double z) {
		const double square = x * x + z * z;
		return square < 100.0 ? -1.0 + 0.01 * square : 0.1 * (10.0 - std::sqrt(square)); // A rim at a radius of 10 m.
	});
	const HabitatRaster moisture = find_moisture(grid);
	CHECK(moisture.at({ 0.0f, 0.0f }) == 1.0f);
	CHECK(moisture.at({ 7.0f, 0.0f }) == 1.0f);
	CHECK(moisture.at({ 12.0f, 0.0f }) < 0.5f);
}

TEST_CASE("water of flat ground leaves by short ways") {
	constexpr int SIDE = 41;
	const HeightGrid grid = grid_of(SIDE, SIDE, 1.0f, [](double, double) { return 0.0; });
	const std::vector<double> areas = find_drained_areas(grid);
	double most = 0.0;
	for (const double area : areas) {
		most = std::max(most, area);
	}
	MESSAGE("at most " << most << " of " << SIDE * SIDE << " m2 drain through one point");
	CHECK(most < 0.1 * SIDE * SIDE);
}

TEST_CASE("water leaves beside points without ground") {
	HeightGrid grid = grid_of(41, 21, 1.0f, [](double x, double) { return -0.1 * x; });
	for (int row = 0; row < 21; row++) {
		grid.heights[grid.index(20, row)] = NO_GROUND;
	}
	const std::vector<double> areas = find_drained_areas(grid);
	CHECK(areas[grid.index(20, 10)] == 0.0);
	CHECK(column_sum(grid, areas, 19) == doctest::Approx(21.0 * 20));
	CHECK(column_sum(grid, areas, 40) == doctest::Approx(21.0 * 20));
	CHECK(find_moisture(grid).at(grid.point(grid.index(20, 10))) == 0.0f);
	HeightGrid nothing = grid;
	nothing.heights.assign(nothing.size(), NO_GROUND);
	for (const float value : find_moisture(nothing).values) {
		CHECK(value == 0.0f);
	}
}

TEST_CASE("a grid covers its box with a margin") {
	const HeightGrid small = HeightGrid::around({ { -10.0f, 0.0f }, { 10.0f, 8.0f } }, 2.0f, 256, 1.0f);
	CHECK(small.step == 1.0f);
	CHECK(small.columns == 25);
	CHECK(small.rows == 13);
	CHECK(small.point(0) == glm::vec2(-12.0f, -2.0f));
	CHECK(small.point(small.size() - 1) == glm::vec2(12.0f, 10.0f));
	const HeightGrid large = HeightGrid::around({ { 0.0f, 0.0f }, { 1000.0f, 100.0f } }, 0.0f, 256, 1.0f);
	CHECK(large.columns == 256);
	CHECK(large.rows < 30);
}

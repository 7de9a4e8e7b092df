#include "../golden.hpp"
#include "placement/curve_key.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <vector>

using namespace undergrowth;

namespace {

struct Cell {
	uint64_t key;
	int column;
	int row;
};

/// The cells of a square, along the curve.
std::vector<Cell> along_curve(int column, int row, int side) {
	std::vector<Cell> cells;
	for (int i = 0; i < side * side; i++) {
		const Cell cell = { 0, column + i % side, row + i / side };
		cells.push_back({ curve_key(cell.column, cell.row), cell.column, cell.row });
	}
	std::sort(cells.begin(), cells.end(), [](const Cell &a, const Cell &b) { return a.key < b.key; });
	return cells;
}

/// True if each cell but the first has the next key and is beside the one before it.
bool goes_through(const std::vector<Cell> &cells) {
	const auto is_next = [](const Cell &a, const Cell &b) {
		return b.key == a.key + 1 && std::abs(b.column - a.column) + std::abs(b.row - a.row) == 1;
	};
	return std::adjacent_find(cells.begin(), cells.end(),
				   [&](const Cell &a, const Cell &b) { return !is_next(a, b); }) == cells.end();
}

} // namespace

TEST_CASE("Hilbert's curve visits all cells of a square, from each to a neighbour") {
	for (const int side : { 2, 4, 8, 16, 32, 128 }) {
		CHECK(goes_through(along_curve(0, 0, side)));
		CHECK(goes_through(along_curve(-side, 0, side)));
		CHECK(goes_through(along_curve(-side, -side, side)));
		CHECK(goes_through(along_curve(77 * side, -1234 * side, side)));
	}
}

TEST_CASE("Hilbert's curve includes the farthest cells, as the first and last ones") {
	constexpr int LOWEST = std::numeric_limits<int>::min();
	constexpr int HIGHEST = std::numeric_limits<int>::max();
	for (const int column : { LOWEST, HIGHEST - 31 }) {
		for (const int row : { LOWEST, HIGHEST - 31 }) {
			CHECK(goes_through(along_curve(column, row, 32)));
		}
	}
	const uint64_t ends[] = { curve_key(LOWEST, LOWEST), curve_key(HIGHEST, LOWEST), curve_key(LOWEST, HIGHEST),
		curve_key(HIGHEST, HIGHEST) };
	CHECK(*std::min_element(std::begin(ends), std::end(ends)) == 0);
	CHECK(*std::max_element(std::begin(ends), std::end(ends)) == std::numeric_limits<uint64_t>::max());
}

TEST_CASE("keys on Hilbert's curve are the same on every platform") {
	constexpr uint64_t GOLDEN = 0xe9cebb6d2737ee19ull;
	GoldenHash hash;
	for (const int step : { 1, 97, 1234567 }) {
		for (int i = 0; i < 1000; i++) {
			const uint64_t key = curve_key((i % 37 - 20) * step, (i / 37 - 9) * step);
			hash.add(&key, 1);
		}
	}
	CHECK(hash.value() == GOLDEN);
}

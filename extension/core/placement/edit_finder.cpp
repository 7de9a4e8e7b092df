#include "placement/edit_finder.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr int MAX_SIDE = 64; // Bins along a side of a square.

/// Max rounding error of a position (m).
float rounding_at(const glm::vec2 &place) {
	return 1e-4f + 1e-6f * (std::abs(place.x) + std::abs(place.y));
}

int bin_at(float place, float low, int side) {
	return std::clamp(static_cast<int>((place - low) / EditLog::SQUARE * static_cast<float>(side)), 0, side - 1);
}

/// Calls visit(bin) for the bins of a square from `low` on that a cell meets.
template <class Cell, class Visit> void for_each_bin(const Cell &cell, glm::vec2 low, int side, const Visit &visit) {
	const float reach = 0.5f * static_cast<float>(cell.spacing) + rounding_at(cell.middle);
	const int last_row = bin_at(cell.middle.y + reach, low.y, side);
	const int last_column = bin_at(cell.middle.x + reach, low.x, side);
	for (int row = bin_at(cell.middle.y - reach, low.y, side); row <= last_row; row++) {
		for (int column = bin_at(cell.middle.x - reach, low.x, side); column <= last_column; column++) {
			visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(side) + static_cast<std::size_t>(column));
		}
	}
}

bool meets(const AreaBox &box, glm::vec2 middle, double spacing) {
	const float reach = 0.5f * static_cast<float>(spacing) + rounding_at(middle);
	return middle.x + reach >= box.low.x && middle.x - reach <= box.high.x && middle.y + reach >= box.low.y &&
			middle.y - reach <= box.high.y;
}

} // namespace

EditFinder::Square EditFinder::index(const TileKey &key) const {
	const AreaBox box = tile_box(key, EditLog::SQUARE);
	std::vector<Cell> found;
	double smallest = EditLog::SQUARE;
	const auto add = [&](PlantId id, double spacing, const double *base) {
		Cell cell = { { 0.0f, 0.0f }, spacing, id, base };
		generated_plant_position(id, spacing, cell.middle.x, cell.middle.y);
		if (meets(box, cell.middle, spacing)) {
			found.push_back(cell);
			smallest = std::min(smallest, spacing);
		}
	};
	const EditLog near = all.cut(box); // Its squares are those of `all`.
	for (const auto &[spacing, near_squares] : near.of_generated()) {
		for (const auto &entry : near_squares) {
			for (const PlantId id : entry.second->gone) {
				add(id, spacing, nullptr);
			}
			for (const MownPlant &plant : entry.second->mown) {
				add(plant.id, spacing, &plant.base);
			}
		}
	}
	Square made;
	if (found.empty()) {
		return made;
	}
	made.side = std::clamp(static_cast<int>(static_cast<double>(EditLog::SQUARE) / smallest), 1, MAX_SIDE);
	const auto bins = static_cast<std::size_t>(made.side * made.side);
	made.first.assign(bins + 1, 0);
	for (const Cell &cell : found) {
		for_each_bin(cell, box.low, made.side, [&](std::size_t bin) { made.first[bin + 1]++; });
	}
	for (std::size_t bin = 0; bin < bins; bin++) {
		made.first[bin + 1] += made.first[bin];
	}
	made.cells.resize(made.first.back());
	std::vector<uint32_t> next = made.first;
	for (const Cell &cell : found) {
		for_each_bin(cell, box.low, made.side, [&](std::size_t bin) { made.cells[next[bin]++] = cell; });
	}
	return made;
}

const EditFinder::Cell *EditFinder::find(float x, float z, bool is_gone) {
	const TileKey key = tile_at(x, z, EditLog::SQUARE);
	if (last_square == nullptr || !(key == last_key)) {
		const auto known = squares.find(key);
		last_square = known != squares.end() ? &known->second : &squares.emplace(key, index(key)).first->second;
		last_key = key;
	}
	const Square &square = *last_square;
	if (square.side == 0) {
		return nullptr;
	}
	const AreaBox box = tile_box(key, EditLog::SQUARE);
	const auto bin =
			static_cast<std::size_t>(bin_at(z, box.low.y, square.side)) * static_cast<std::size_t>(square.side) +
			static_cast<std::size_t>(bin_at(x, box.low.x, square.side));
	for (uint32_t i = square.first[bin]; i < square.first[bin + 1]; i++) {
		const Cell &cell = square.cells[i];
		compared++;
		if ((cell.base == nullptr) == is_gone && meets({ { x, z }, { x, z } }, cell.middle, cell.spacing) &&
				generated_plant_id(x, z, cell.spacing) == cell.id) {
			return &cell;
		}
	}
	return nullptr;
}

} // namespace undergrowth

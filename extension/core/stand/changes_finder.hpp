#pragma once

#include "stand/stand_changes.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace undergrowth {

/// Looks up many filled plants in StandChanges that stay as they are. Indexes the recorded cells by place, one square
/// at a time, so a look-up costs by the cells around the plant, however many densities the changes were made at. One
/// thread.
class ChangesFinder {
public:
	explicit ChangesFinder(const StandChanges &changes) : all(changes) {}

	/// As StandChanges has them, of a filled plant with this root (m).
	bool is_gone(float x, float z) { return find(x, z, true) != nullptr; }
	const double *find_mown(float x, float z) {
		const Cell *cell = find(x, z, false);
		return cell != nullptr ? cell->base : nullptr;
	}
	/// The number of cells that look-ups compared so far.
	int64_t compared_cells() const { return compared; }

private:
	struct Cell {
		glm::vec2 middle = { 0.0f, 0.0f }; ///< m.
		double spacing = 1.0; ///< m.
		PlantId id = NO_PLANT;
		const double *base = nullptr; ///< Of a mown plant. Null: it is gone.
	};
	/// The cells that meet a square, sorted into bins of equal size; a cell is in each bin that it meets.
	struct Square {
		int side = 0; ///< Bins along a side; 0 without cells.
		std::vector<uint32_t> first; ///< In `cells`, by bin; one more at the end.
		std::vector<Cell> cells;
	};

	const StandChanges &all;
	std::map<TileKey, Square> squares; ///< Those that were looked at.
	TileKey last_key;
	const Square *last_square = nullptr;
	int64_t compared = 0;

	const Cell *find(float x, float z, bool is_gone);
	Square index(const TileKey &key) const;
};

} // namespace undergrowth

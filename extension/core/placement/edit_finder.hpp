#pragma once

#include "placement/edit_log.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace undergrowth {

/// Looks up many generated plants in an EditLog that does not change. Indexes the recorded cells by position, one
/// square at a time. The cost of a look-up depends on the cells around the plant, not on the number of densities of the
/// edits. One thread.
class EditFinder {
public:
	explicit EditFinder(const EditLog &edits) : all(edits) {}

	/// The same as in EditLog, for a generated plant with this root (m).
	bool is_gone(float x, float z) { return find(x, z, true) != nullptr; }
	const double *find_mown(float x, float z) {
		const Cell *cell = find(x, z, false);
		return cell != nullptr ? cell->base : nullptr;
	}
	/// Number of cells that look-ups have compared.
	int64_t compared_cells() const { return compared; }

private:
	struct Cell {
		glm::vec2 middle = { 0.0f, 0.0f }; ///< m.
		double spacing = 1.0; ///< m.
		PlantId id = NO_PLANT;
		const double *base = nullptr; ///< Of a mown plant. Null: the plant is removed.
	};
	/// The cells that meet a square, sorted into bins of equal size. A cell is in each bin that it meets.
	struct Square {
		int side = 0; ///< Bins along a side; 0 without cells.
		std::vector<uint32_t> first; ///< Index in `cells`, by bin; one more at the end.
		std::vector<Cell> cells;
	};

	const EditLog &all;
	std::map<TileKey, Square> squares; ///< Squares indexed on demand.
	TileKey last_key;
	const Square *last_square = nullptr;
	int64_t compared = 0;

	const Cell *find(float x, float z, bool is_gone);
	Square index(const TileKey &key) const;
};

} // namespace undergrowth

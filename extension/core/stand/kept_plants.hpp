#pragma once

#include "stand/plant_store.hpp"

#include <utility>
#include <vector>

namespace undergrowth {

/// Plants that were filled: their blocks, and the spacing (m) of the placement that they were filled by last.
struct FilledBlocks {
	std::vector<std::pair<int, PlantBlock>> blocks; ///< With the number of each in a store.
	double spacing = 1.0;
};

/// A copy of all that is filled in a store.
FilledBlocks copy_filled(const PlantStore &store);
/// The same of a tile.
FilledBlocks copy_filled_in(const PlantStore &store, const TileKey &tile);

/// Those of them that stand, of species that go on: `species_numbers` says what species are now (-1: no more), by what
/// they were.
FieldPlants gather_plants(const FilledBlocks &filled, const std::vector<int> &species_numbers);

/// A plant that stood before and stands again.
struct KeptPlant {
	PlantPlace from; ///< As it was.
	PlantPlace to; ///< Its block by its index in `now`.
};

/// Who of `before` stands again in `now`, which was filled at `spacing` (m): those of the same names at the same
/// spacing.
std::vector<KeptPlant> find_kept(const FilledBlocks &before, const std::vector<PlantBlock> &now, double spacing);

} // namespace undergrowth

#pragma once

#include "stand/plant_store.hpp"

#include <utility>
#include <vector>

namespace undergrowth {

/// Generated plants: their blocks, and the spacing (m) of their last placement.
struct FilledBlocks {
	std::vector<std::pair<int, PlantBlock>> blocks; ///< Each with its number in the store.
	double spacing = 1.0;
};

/// Copies all generated plants of a store.
FilledBlocks copy_filled(const PlantStore &store);
/// The same for one tile.
FilledBlocks copy_filled_in(const PlantStore &store, const TileKey &tile);

/// Collects the existing plants of species that remain. `species_numbers` maps old species to new ones (-1: removed).
FieldPlants gather_plants(const FilledBlocks &filled, const std::vector<int> &species_numbers);

/// A plant that exists before and after a build.
struct KeptPlant {
	PlantPlace from; ///< In the old store.
	PlantPlace to; ///< Block as an index in `now`.
};

/// Matches plants of `before` that also exist in `now`, which was placed at `spacing` (m), by id and spacing.
std::vector<KeptPlant> find_kept(const FilledBlocks &before, const std::vector<PlantBlock> &now, double spacing);

} // namespace undergrowth

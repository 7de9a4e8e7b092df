#pragma once

#include "placement/plant_store.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace undergrowth {

/// Generated plants: their chunks, and the spacing (m) of their last placement.
struct GeneratedChunks {
	std::vector<std::pair<int, std::shared_ptr<const PlantChunk>>> chunks; ///< Each with its number in the store.
	double spacing = 1.0;
};

/// Returns all generated plants of a store. Later edits of the store do not change them, and any thread may read them.
GeneratedChunks share_generated(const PlantStore &store);
/// The same for one tile.
GeneratedChunks share_generated_in(const PlantStore &store, const TileKey &tile);

/// Collects the existing plants of species that remain. `species_numbers` maps old species to new ones (-1: removed).
FieldPlants gather_plants(const GeneratedChunks &generated, const std::vector<int> &species_numbers);

/// A plant that exists before and after a build.
struct PlantMatch {
	PlantRef from; ///< In the old store.
	PlantRef to; ///< Chunk as an index in `now`.
};

/// Matches plants of `before` that also exist in `now`, which was placed at `spacing` (m), by id and spacing.
std::vector<PlantMatch> match_plants(const GeneratedChunks &before, const std::vector<PlantChunk> &now, double spacing);

} // namespace undergrowth

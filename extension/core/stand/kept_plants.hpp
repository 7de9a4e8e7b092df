#pragma once

#include "stand/plant_store.hpp"

#include <utility>
#include <vector>

namespace undergrowth {

/// A plant that stood before and stands again.
struct KeptPlant {
	PlantPlace from; ///< In the store as it was.
	PlantPlace to; ///< Its block by its index among the new ones.
};

/// A block with its number in the store.
using NumberedBlock = std::pair<int, PlantBlock>;

/// Which plants stand again: those of the same names (filled_plant_id), whatever else became of them. Whoever is gone
/// does not. By where they are now.
std::vector<KeptPlant> find_kept(const std::vector<NumberedBlock> &before, double old_spacing,
		const std::vector<PlantBlock> &now, double spacing);

} // namespace undergrowth

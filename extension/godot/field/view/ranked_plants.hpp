#pragma once

#include "field/view/batch_plans.hpp"
#include "field/view/drawn_plant.hpp"

#include <vector>

namespace undergrowth {

/// All plants of some chunks, without removed ones.
struct RankedPlants {
	std::vector<DrawnPlant> plants; ///< In the order of their chunks, so that neighbours are adjacent in memory.
	std::vector<float> reaches; ///< m, by plant: distance from its root at the largest deflection.
	std::vector<int> begins; ///< First plant of each chunk, and the end of the last one.
	float width = 0.0f; ///< m, of the box around the generated plants.
	std::vector<int> by_rank; ///< Plant indices by rank; plants of equal rank are in the order of their chunks.
};

/// Any thread.
RankedPlants rank_plants(const FieldRenderSetup &setup, const std::vector<DrawnChunk> &chunks);

} // namespace undergrowth

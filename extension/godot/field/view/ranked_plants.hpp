#pragma once

#include "field/view/batch_plans.hpp"

#include <glm/vec3.hpp>

#include <vector>

namespace undergrowth {

/// Data of a plant that all levels of detail draw it with.
struct DrawnPlant {
	glm::vec3 root = glm::vec3(0.0f); ///< m.
	float scale = 1.0f;
	float cosine = 1.0f, sine = 0.0f; ///< Cosine and sine of its turn, times its scale.
	/// Location of its pose, as stored in instances.
	float texel = 0.0f, layer = 0.0f;
	float rank = 0.0f;
	int step = 0; ///< The rank, rounded up: 0 to RANK_STEPS.
	float height = 0.0f; ///< m.
	float reach = 0.0f; ///< Distance from its root at the largest deflection (m).
	int variant = 0;
	float lightness = 0.0f, warmth = 0.0f; ///< Of its color, -1 to 1.
};

/// All plants of some chunks, without removed ones.
struct RankedPlants {
	std::vector<DrawnPlant> plants; ///< In the order of their chunks, so that neighbours are adjacent in memory.
	std::vector<int> begins; ///< First plant of each chunk, and the end of the last one.
	float width = 0.0f; ///< m, of the box around the generated plants.
	std::vector<int> by_rank; ///< Plant indices by rank; plants of equal rank are in the order of their chunks.
};

/// Any thread.
RankedPlants rank_plants(const FieldRenderSetup &setup, const std::vector<DrawnChunk> &chunks);

} // namespace undergrowth

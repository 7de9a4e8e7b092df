#pragma once

#include "field/field_view.hpp"

#include <glm/vec3.hpp>

#include <vector>

namespace undergrowth {

/// A plant as it is drawn at all levels of detail.
struct DrawnPlant {
	glm::vec3 root = glm::vec3(0.0f); ///< m.
	float scale = 1.0f;
	float cosine = 1.0f, sine = 0.0f; ///< Of its turn, times its scale.
	/// Where its pose is, as instances say it.
	float texel = 0.0f, layer = 0.0f;
	float rank = 0.0f;
	int step = 0; ///< Of the rank, rounded up: 0 to RANK_STEPS.
	float height = 0.0f; ///< m.
	float reach = 0.0f; ///< m: as far from its root as its largest deflection takes it.
	int variant = 0;
};

/// All plants of some blocks that are not gone.
struct RankedPlants {
	std::vector<DrawnPlant> plants; ///< Block by block, so that those of one place are side by side.
	std::vector<int> begins; ///< Of each block, and the end of the last.
	std::vector<int> by_rank; ///< Their numbers; of equal ranks in the order of their blocks.
};

/// On any thread.
RankedPlants rank_plants(const FieldStyle &style, const std::vector<DrawnBlock> &blocks);

} // namespace undergrowth

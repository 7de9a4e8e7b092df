#pragma once

#include "mesh/form_bones.hpp"
#include "model/model_parts.hpp"

namespace undergrowth {

/// The bones of an island.
struct ModelSwinger {
	int number = -1; ///< For FormBones::bind; -1: none.
	float share = 1.0f; ///< Of its swing: bones of other parts turn it about a pivot that is not its own.
};

/// Returns bones for the parts that swing. Each gets one while there are enough bones; otherwise parts near each
/// other share them. `height`: of the plant (m). `swingers`: gets the bones of each island.
FormBones make_model_bones(const std::vector<ModelPart> &parts, const ModelIslands &islands, float height,
		std::vector<ModelSwinger> &swingers);

/// Moves the weights of vertices near the ground to the root's bone, so that a thick base is still. `places`: positions
/// on the stem where the vertices are attached.
void hold_base(int vertices, const float *places, int32_t *bones, float *weights);

} // namespace undergrowth

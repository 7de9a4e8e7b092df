#pragma once

#include "mesh/form_bones.hpp"
#include "model/model_parts.hpp"

namespace undergrowth {

/// Returns bones for the parts that swing. Each gets one while there are enough bones; otherwise parts near each other
/// share them. `height`: of the plant (m). `swingers`: gets the number for FormBones::bind of each island, or -1.
FormBones make_model_bones(
		const std::vector<ModelPart> &parts, const ModelIslands &islands, float height, std::vector<int> &swingers);

} // namespace undergrowth

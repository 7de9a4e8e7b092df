#pragma once

#include "form/plant_form.hpp"

#include <vector>

namespace undergrowth {

/// How a part hangs on the plant that bends (mesh/vertex_format.hpp).
struct PartHang {
	bool is_root = false; ///< It stands on the ground: the stem offset of its vertices is their own height's.
	float stem_offset = 0.0f; ///< Of all its vertices, unless it is a root.
	bool swings = false; ///< By itself: the own weight of its vertices is their offset.
	float weight = 0.0f; ///< Of all its vertices, unless it swings.
	glm::vec3 pivot = glm::vec3(0.0f); ///< m.
	float frequency = 0.0f; ///< Hz.
	float phase = 0.0f; ///< 0 to 1.
	float rank = 0.0f; ///< At least that of what carries it.

	/// The own weight at a part's offset.
	float weight_at(float offset) const { return swings ? offset : weight; }
};

/// Of all placed parts.
std::vector<PartHang> hang_parts(const PlantForm &form);

/// The stem offset of a point of what stands on the ground.
float stem_offset_of(const PlantForm &form, const glm::vec3 &point);

} // namespace undergrowth

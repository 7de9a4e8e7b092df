#pragma once

#include "plant/height_range.hpp"
#include "plant/motion.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace undergrowth {

/// Common reed: a thin stem with joints and a feathery brown plume at the top.
struct Reed {
	glm::vec4 stem_color = { 0.42f, 0.54f, 0.22f, 1.0f };
	glm::vec4 joint_color = { 0.66f, 0.60f, 0.32f, 1.0f };
	glm::vec4 plume_color = { 0.36f, 0.23f, 0.15f, 1.0f };
	glm::vec4 plume_tip_color = { 0.68f, 0.52f, 0.36f, 1.0f };
	float stem_radius = 0.012f; ///< m.

	/// A ring for `lod` segments (plant/base_shape.hpp).
	std::vector<glm::vec2> base_shape(int lod) const;
	/// Factor of the ring at `offset`, >= 0.
	float width(float offset) const;
	glm::vec4 color(float offset) const;

	static constexpr HeightRange heights = { 1.6f, 2.6f };
	static Motion motion();
};

} // namespace undergrowth

#pragma once

#include "plant/height_range.hpp"
#include "plant/motion.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace undergrowth {

/// One blade of grass: a parallelogram that tapers to a point, dark at the root and yellowish at the tip.
struct Grass {
	glm::vec4 root_color = { 0.09f, 0.26f, 0.07f, 1.0f };
	glm::vec4 middle_color = { 0.26f, 0.50f, 0.14f, 1.0f };
	glm::vec4 tip_color = { 0.62f, 0.68f, 0.30f, 1.0f };
	float blade_width = 0.034f; ///< m, where the blade is widest.

	/// A ring for `lod` segments (plant/base_shape.hpp).
	std::vector<glm::vec2> base_shape(int lod) const;
	/// Factor of the ring at `offset`, >= 0.
	float width(float offset) const;
	glm::vec4 color(float offset) const;

	static constexpr HeightRange heights = { 0.4f, 0.9f };
	static Motion motion();
};

} // namespace undergrowth

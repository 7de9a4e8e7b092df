#pragma once

#include "plant/height_range.hpp"
#include "plant/motion.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace undergrowth {

/// Cattail: a straight stem, the brown velvet head, and a thin spike on top.
struct Cattail {
	glm::vec4 stem_color = { 0.33f, 0.52f, 0.20f, 1.0f };
	glm::vec4 head_color = { 0.31f, 0.16f, 0.07f, 1.0f };
	glm::vec4 spike_color = { 0.72f, 0.62f, 0.36f, 1.0f };
	float stem_radius = 0.011f; ///< m.

	/// A ring for `lod` segments (plant/base_shape.hpp).
	std::vector<glm::vec2> base_shape(int lod) const;
	/// Factor of the ring at `offset`, >= 0.
	float width(float offset) const;
	glm::vec4 color(float offset) const;

	static constexpr HeightRange heights = { 1.4f, 2.2f };
	static Motion motion();
};

} // namespace undergrowth

#pragma once

#include "plant/height_range.hpp"
#include "plant/motion.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace undergrowth {

/// Bellflower: a thin stem that nods under a violet bell with five petals.
struct Bellflower {
	glm::vec4 stem_color = { 0.25f, 0.48f, 0.20f, 1.0f };
	glm::vec4 bell_color = { 0.56f, 0.50f, 0.88f, 1.0f };
	glm::vec4 rim_color = { 0.38f, 0.26f, 0.72f, 1.0f };
	float bell_radius = 0.07f; ///< m, at the rim.

	/// A ring for `lod` segments (plant/base_shape.hpp).
	std::vector<glm::vec2> base_shape(int lod) const;
	/// Factor of the ring at `offset`, >= 0.
	float width(float offset) const;
	glm::vec4 color(float offset) const;

	static constexpr HeightRange heights = { 0.5f, 0.9f };
	static Motion motion();
};

} // namespace undergrowth

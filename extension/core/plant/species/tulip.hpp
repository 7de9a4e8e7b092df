#pragma once

#include "plant/height_range.hpp"
#include "plant/motion.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace undergrowth {

/// The thesis's tulip, to the digit (section 2.5): a thin stem and a bell of half a flattened sine.
struct Tulip {
	glm::vec4 stem_color = { 0.2f, 0.85f, 0.2f, 1.0f };
	glm::vec4 flower_color = { 0.8f, 0.1f, 0.1f, 1.0f };

	/// A ring for `lod` segments (plant/base_shape.hpp).
	std::vector<glm::vec2> base_shape(int lod) const;
	/// Factor of the ring at `offset`, >= 0.
	float width(float offset) const;
	glm::vec4 color(float offset) const;

	static constexpr HeightRange heights = { 1.2f, 2.2f };
	static Motion motion();
};

} // namespace undergrowth

#pragma once

#include "mesh/cross_section.hpp"

#include <glm/vec4.hpp>

#include <vector>

namespace undergrowth {

/// A plant function, asked at one height and level of detail: all that its mesh needs.
struct SampledPlant {
	CrossSection cross_section;
	std::vector<float> widths; ///< lod + 1.
	std::vector<glm::vec4> colors; ///< lod + 1.
	float height = 0.0f; ///< m.
	int lod = 0;

	/// The largest distance of a side point from the plant's axis (m).
	float widest() const;
};

} // namespace undergrowth

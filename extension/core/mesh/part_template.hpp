#pragma once

#include "form/surface.hpp"
#include "mesh/part_detail.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace undergrowth {

/// A vertex that all parts of one kind and one detail share.
struct TemplateVertex {
	SurfacePoint point;
	glm::vec4 color;
	glm::vec2 uv;
	float offset; ///< Along the part, 0 to 1.
	float lean; ///< Lean of its normal across the part: the tangent of the angle. 0 on tubes.
};

/// The surface of a kind of part at one detail, for a length and a width of 1.
struct PartTemplate {
	std::vector<TemplateVertex> vertices;
	std::vector<int32_t> indices;
};

/// Builds the template with the part's mean colour (mean_color()) at any detail. It has as many vertices and indices as
/// count_part() returns.
PartTemplate make_part_template(
		const Part &part, const Midrib &midrib, const PartDetail &detail, const glm::vec4 &mean_color);

} // namespace undergrowth

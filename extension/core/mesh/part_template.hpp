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

/// Surface of a kind of part at one detail, for length and width 1.
struct PartTemplate {
	std::vector<TemplateVertex> vertices;
	std::vector<int32_t> indices;
};

/// Computes it in the part's own mean colour (mean_color()), at any detail. Vertex and index counts are those of
/// count_part().
PartTemplate make_part_template(
		const Part &part, const Midrib &midrib, const PartDetail &detail, const glm::vec4 &mean_color);

} // namespace undergrowth

#pragma once

#include "conventions.hpp"
#include "form/plant_form.hpp"
#include "mesh/part_hang.hpp"
#include "mesh/silhouette.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <vector>

namespace undergrowth {

/// What all levels of a form share, once a seed: how its parts hang, and what it shows when every part of it is drawn
/// as finely as parts are drawn: what its levels are held to.
struct FormMeasure {
	/// m² of each group's silhouette from the side: the mean over all directions along the ground, were no part
	/// before another.
	std::vector<float> shown;
	Outlines outlines = {}; ///< m² of the whole plant from each side, what lies behind other parts once.
	glm::vec3 light = glm::vec3(0.0f); ///< Its mean colour from all sides, linear.
	float from_above = 0.0f; ///< m² of the whole plant from straight above.
	float translucency = 0.0f; ///< Of its parts, on the mean, by what each group shows.
	SightBox box; ///< What outlines and light are measured in.
	std::vector<glm::vec4> colors; ///< The mean colour of each kind of part.
	std::vector<float> mean_widths; ///< Of each kind, in shares of its width.
	std::vector<PartHang> hangs; ///< Of each placed part.
};

FormMeasure measure_form(const PlantForm &form);

/// The mean colour of a part, as light adds up: by the squares of its components, weighed by its width.
glm::vec4 mean_color(const Part &part);

/// Twice a triangle's mean silhouette along the ground (m²). A plane of normal n and area A shows A·|n·v| from v, and
/// the mean of |n·v| over the directions v along the ground is 2/π of the part of n that lies along it.
inline float twice_shown(const glm::vec3 &a, const glm::vec3 &b, const glm::vec3 &c) {
	const glm::vec3 twice_area = glm::cross(b - a, c - a);
	return std::sqrt(twice_area.x * twice_area.x + twice_area.z * twice_area.z) * static_cast<float>(2.0 / PI);
}

/// The share of a part's triangles that is seen: of a closed one the nearer half.
float near_share(PartKind kind);

} // namespace undergrowth

#pragma once

#include "conventions.hpp"
#include "form/plant_form.hpp"
#include "mesh/part_hang.hpp"
#include "mesh/silhouette.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <vector>

namespace undergrowth {

/// Data that all levels of a form share, measured once per seed: the hang of its parts, and the areas and colours of
/// the form with every part drawn at the finest detail. Levels must match these.
struct FormMeasure {
	/// m² of each group's silhouette from the side: the mean over all directions along the ground, as if no part hid
	/// another.
	std::vector<float> shown;
	Outlines outlines = {}; ///< m² of the whole plant from each side; parts behind other parts do not count again.
	glm::vec3 light = glm::vec3(0.0f); ///< Mean colour from all sides, linear.
	float from_above = 0.0f; ///< m² of the whole plant from straight above.
	float translucency = 0.0f; ///< Mean of its parts, weighted by the area that each group shows.
	SightBox box; ///< Box for measuring outlines and light.
	std::vector<glm::vec4> colors; ///< Mean colour of each kind of part.
	std::vector<float> mean_widths; ///< Of each kind, as a fraction of its width.
	std::vector<PartHang> hangs; ///< Of each placed part.
};

FormMeasure measure_form(const PlantForm &form);

/// Mean colour of a part, as light adds up: by the squares of its components, weighted by its width.
glm::vec4 mean_color(const Part &part);

/// Twice a triangle's mean silhouette along the ground (m²). A plane with normal n and area A shows A·|n·v| from v. The
/// mean of |n·v| over the directions v along the ground is 2/π times the horizontal part of n.
inline float twice_shown(const glm::vec3 &a, const glm::vec3 &b, const glm::vec3 &c) {
	const glm::vec3 twice_area = glm::cross(b - a, c - a);
	return std::sqrt(twice_area.x * twice_area.x + twice_area.z * twice_area.z) * static_cast<float>(2.0 / PI);
}

/// Fraction of a part's triangles that is visible: of a closed part the nearer half.
float near_share(PartKind kind);

} // namespace undergrowth

#pragma once

#include "conventions.hpp"
#include "form/plant_form.hpp"
#include "mesh/level_error.hpp"
#include "mesh/part_attachment.hpp"
#include "mesh/silhouette.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <vector>

namespace undergrowth {

/// Data of a form that all its levels share, computed once per seed: attachments of parts, and the reference outlines
/// and colours that levels are fitted to. The reference draws all parts at their finest detail.
struct FormMeasure {
	/// m² of each group's silhouette from the side: the mean over all horizontal directions, without occlusion.
	std::vector<float> shown;
	Outlines outlines = {}; ///< Silhouette of the whole plant from each side (m²), with occlusion.
	/// Mean colour from all sides, linear, with the tones of materials (mesh/shown_tone.hpp).
	glm::vec3 light = glm::vec3(0.0f);
	float tone = 1.0f; ///< The mean of these tones.
	float from_above = 0.0f; ///< Area of the whole plant from straight above (m²).
	float translucency = 0.0f; ///< Mean over its parts, weighted by each group's shown area.
	SightBox box; ///< The box for measuring outlines and light.
	std::vector<glm::vec4> colors; ///< Mean colour of each kind of part.
	std::vector<float> mean_widths; ///< By kind, as fractions of its width.
	std::vector<PartAttachment> attachments; ///< By placed part.
};

FormMeasure measure_form(const PlantForm &form);

/// Returns the outlines of a plant with all parts, for the errors of its levels.
LevelError measure_outline(const PlantForm &form);

/// Returns the mean colour of a part in linear light: means of squared components, weighted by width.
glm::vec4 mean_color(const Part &part);

/// Returns twice a triangle's mean silhouette over horizontal directions (m²). A plane with normal n and area A has the
/// silhouette A·|n·v| from direction v. The mean of |n·v| over horizontal v is 2/π of n's horizontal part.
inline float twice_shown(const glm::vec3 &a, const glm::vec3 &b, const glm::vec3 &c) {
	const glm::vec3 twice_area = glm::cross(b - a, c - a);
	return std::sqrt(twice_area.x * twice_area.x + twice_area.z * twice_area.z) * static_cast<float>(2.0 / PI);
}

/// Returns the visible fraction of a part's triangles: half for a closed part.
float near_share(PartKind kind);

} // namespace undergrowth

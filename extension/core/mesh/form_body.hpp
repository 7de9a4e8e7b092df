#pragma once

#include "mesh/form_plan.hpp"
#include "mesh/part_attachment.hpp"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace undergrowth {

/// One body that replaces all parts of a group on one carrier, and everything on these parts, at a distance. A disc
/// becomes a dome, a whorl the lathe of its midribs with a closed base, parts along an axis a spindle, or an open rod
/// if they are close to it, as in an ear. It has the parts' mean colour and their size from the side. A broad spindle,
/// as of an umbel, has the colour of the parts below its widest ring, and above it the colour seen from its tip.
struct FormBody {
	struct Ring {
		float along = 0.0f; ///< m along the axis from the origin, or along the carrier.
		float radius = 0.0f; ///< m.
		glm::vec4 color = glm::vec4(0.0f);
		// Set by DrawnAttachments:
		glm::vec3 middle = glm::vec3(0.0f); ///< m.
		PartAxes axes = {};
		PartAttachment attachment = {};

		Ring(float p_along, float p_radius) : along(p_along), radius(p_radius) {}
	};
	int group = 0;
	BodyDetail detail;
	int first = 0; ///< First placed part of the body.
	glm::vec3 origin = glm::vec3(0.0f); ///< m, in the plant's axes.
	PartAxes axes;
	std::vector<Ring> rings;
	bool has_base = false; ///< True if a pole closes it at the position of the first ring, with radius 0.
	bool has_tip = false;
	float translucency = 0.0f;
	float shown = 0.0f; ///< Target area from the side (m²); 0: its own area.
};

/// Returns the bodies of a plan by their numbers.
std::vector<FormBody> make_bodies(const PlantForm &form, const FormMeasure &measure, const FormPlan &plan);

} // namespace undergrowth

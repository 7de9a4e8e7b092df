#pragma once

#include "mesh/form_plan.hpp"
#include "mesh/part_hang.hpp"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace undergrowth {

/// The body that replaces, far away, all parts of a group on one carrier with everything that they carry. A disc
/// becomes its dome. A whorl becomes the lathe of its midribs, closed at its base. Parts along an axis become a
/// spindle. The body has the parts' mean colour and their size from the side.
struct FormBody {
	struct Ring {
		float along = 0.0f; ///< m along the axis from the origin, or along the carrier for parts along a carrier.
		float radius = 0.0f; ///< m.
		// Attachments sets these:
		glm::vec3 middle = glm::vec3(0.0f); ///< m.
		PartAxes axes = {};
		PartHang hang = {};

		Ring(float p_along, float p_radius) : along(p_along), radius(p_radius) {}
	};
	int group = 0;
	BodyDetail detail;
	int first = 0; ///< First placed part in the body.
	glm::vec3 origin = glm::vec3(0.0f); ///< m, in the plant's axes.
	PartAxes axes;
	std::vector<Ring> rings;
	bool has_base = false; ///< A pole of radius 0 closes the body at the position of the first ring.
	bool has_tip = false;
	glm::vec4 color = glm::vec4(0.0f);
	float translucency = 0.0f;
	float shown = 0.0f; ///< Area (m²) to show from the side; 0: its own area.
};

/// Returns the bodies of a plan, in the order of their numbers.
std::vector<FormBody> make_bodies(const PlantForm &form, const FormMeasure &measure, const FormPlan &plan);

} // namespace undergrowth

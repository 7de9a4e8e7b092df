#pragma once

#include "mesh/form_plan.hpp"
#include "mesh/part_hang.hpp"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace undergrowth {

/// The one body that stands for all parts of a group on one carrier and whatever these carry, far away: of a disc its
/// dome, of a whorl the lathe of its midribs, closed at its base, of what stands along an axis a spindle. In the parts'
/// mean colour and as large as they look from the side.
struct FormBody {
	struct Ring {
		float along = 0.0f; ///< m along the axis from the origin; of what is along a carrier, along that.
		float radius = 0.0f; ///< m.
		// Where Attachments place it:
		glm::vec3 middle = glm::vec3(0.0f); ///< m.
		PartAxes axes = {};
		PartHang hang = {};

		Ring(float p_along, float p_radius) : along(p_along), radius(p_radius) {}
	};
	int group = 0;
	BodyDetail detail;
	int first = 0; ///< The first placed part in it.
	glm::vec3 origin = glm::vec3(0.0f); ///< m, in the plant's axes.
	PartAxes axes;
	std::vector<Ring> rings;
	bool has_base = false; ///< A pole closes it there, at the first ring's place; of radius 0.
	bool has_tip = false;
	glm::vec4 color = glm::vec4(0.0f);
	float translucency = 0.0f;
	float shown = 0.0f; ///< m² that it is to show from the side; 0: as much as it does.
};

/// The bodies of a plan, in the order of their numbers.
std::vector<FormBody> make_bodies(const PlantForm &form, const FormMeasure &measure, const FormPlan &plan);

} // namespace undergrowth

#pragma once

#include "mesh/form_body.hpp"
#include "mesh/form_plan.hpp"
#include "mesh/part_attachment.hpp"

#include <glm/vec3.hpp>

#include <vector>

namespace undergrowth {

/// A part as a plan draws it: straight between its rows, which are on the curve of the grown part.
class DrawnPart {
public:
	/// `shift`: from the grown position to the drawn one (m). The arguments must outlive the object.
	DrawnPart(const PlantForm &form, const FormPlan &plan, int part, const glm::vec3 &shift);

	/// Returns a point on the drawn midrib (m), extended straight beyond the ends.
	glm::vec3 point_at(float offset) const;
	/// For parts on the ground: returns the stem offset that leaves a bent point between the rows beside it.
	float stem_offset_at(float offset) const;

private:
	struct Row {
		float offset;
		glm::vec3 place; ///< m.
	};
	const PlantForm &form;
	std::vector<Row> rows;

	const Row &row_below(float offset) const;
};

/// Attaches everything that a plan draws to its carrier as the plan draws that.
class DrawnAttachments {
public:
	/// The arguments must outlive the object.
	DrawnAttachments(const PlantForm &form, const FormPlan &plan, const std::vector<PartAttachment> &grown);

	const PartAttachment &attachment_of(size_t part) const { return attachments[part]; }
	/// From a part's grown position to its drawn one (m).
	const glm::vec3 &shift_of(size_t part) const { return shifts[part]; }
	/// Returns the attachment of a point on a drawn carrier, and its position (m).
	PartAttachment attachment_on(size_t carrier, float offset, glm::vec3 &place) const;
	/// Places the rings of a body on its carrier.
	void place_rings(FormBody &body) const;

private:
	const PlantForm &form;
	const FormPlan &plan;
	std::vector<PartAttachment> attachments;
	std::vector<glm::vec3> shifts;

	void attach(size_t part, const DrawnPart &carrier);
	PartAttachment attachment_at(const PartAttachment &carrier, const DrawnPart &drawn, float offset) const;
};

} // namespace undergrowth

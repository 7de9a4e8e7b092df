#pragma once

#include "mesh/form_body.hpp"
#include "mesh/form_plan.hpp"
#include "mesh/part_hang.hpp"

#include <glm/vec3.hpp>

#include <vector>

namespace undergrowth {

/// A part as a plan draws it: straight between its rows, beside the curve on which it grew and bends.
class DrawnPart {
public:
	/// `shift`: m, from where the part grew to where it is drawn. The arguments outlive it.
	DrawnPart(const PlantForm &form, const FormPlan &plan, int part, const glm::vec3 &shift);

	/// A place on the drawn midrib, m. Beyond the ends it goes straight on.
	glm::vec3 point_at(float offset) const;
	/// Of a part on the ground: the stem offset with which a bent place stays between the rows beside it.
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

/// Attaches all that a plan draws to what carries it as that is drawn.
class Attachments {
public:
	/// The arguments outlive it.
	Attachments(const PlantForm &form, const FormPlan &plan, const std::vector<PartHang> &grown);

	const PartHang &hang_of(size_t part) const { return hangs[part]; }
	/// m, from where a part grew to where it is drawn.
	const glm::vec3 &shift_of(size_t part) const { return shifts[part]; }
	/// Places the rings of a body on its carrier.
	void place_rings(FormBody &body) const;

private:
	const PlantForm &form;
	const FormPlan &plan;
	std::vector<PartHang> hangs;
	std::vector<glm::vec3> shifts;

	void attach(size_t part, const DrawnPart &carrier);
	PartHang hang_at(const PartHang &carrier, const DrawnPart &drawn, float offset) const;
};

} // namespace undergrowth

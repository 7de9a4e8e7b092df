#pragma once

#include "form/plant_form.hpp"
#include "mesh/form_measure.hpp"
#include "mesh/part_detail.hpp"

#include <vector>

namespace undergrowth {

/// Returns the maximum number of vertices of a plant of parts at a level: 792, 198, 50, 22, 12 for 12, 6, 3, 2, 1
/// vertical segments.
int vertex_budget(int lod);

/// Levels finer than this draw petals, leaves and bells with the roundness that a close-up needs.
inline constexpr int FINEST_USUAL_LOD = 12;

/// Detail of a body (mesh/form_body.hpp).
struct BodyDetail {
	int sides = 0;
	int rings = 1; ///< 1 or 2 for a whorl, 1 for all other bodies.
	bool is_rod = false; ///< An open rod in place of a spindle.
};

/// Detail of one group at one level.
struct GroupPlan {
	PartDetail detail;
	float density = 1.0f; ///< Fraction of its parts, by rank; 0: none.
	/// The body that replaces all parts on a carrier and everything on them. Without sides, parts are drawn.
	BodyDetail body;
};

/// The drawn parts and bodies of a form at one level.
struct FormPlan {
	enum Fate : uint8_t {
		drawn, ///< As a part.
		merged, ///< In a body.
		dropped,
	};
	std::vector<GroupPlan> groups;
	std::vector<Fate> fates; ///< By placed part.
	std::vector<int> bodies; ///< By placed part: number of the body for a merged part, from 0; else -1.
	int body_count = 0;
	/// Target area of each group from the side (m², mean): that of all its parts (FormMeasure). The area of a dropped
	/// group is added to those of similar groups. 0: not drawn.
	std::vector<float> shown;
	bool is_cut = false; ///< True if anything is drawn with less than its full detail.
	MeshCounts counts;
};

/// Returns the size of the body of a group on one carrier.
MeshCounts count_body(const PartGroup &group, const BodyDetail &detail);

/// The cards on the parts of a form. They are drawn where their carrier is drawn.
struct CarriedCards {
	std::vector<int> vertices; ///< By placed part: of the cards that it carries. Empty: no cards.
	std::vector<float> areas; ///< By group: of its cards from the side (m²).
	std::vector<glm::vec4> colors; ///< By group: their mean colour.

	bool is_empty() const { return vertices.empty(); }
};

/// Reduces detail until the mesh has at most `budget` vertices, 12 or more. Each step has the smallest change of the
/// silhouette per saved vertex. Usually the details of many small parts are first: they become pyramids, then one dome
/// or spindle in their mean colour. Columns, rows, parts by rank and the stem's roundness follow.
/// The budget includes the cards, `counts` does not.
FormPlan plan_form(const PlantForm &form, const FormMeasure &measure, int budget, const CarriedCards &cards = {});

/// True if a body replaces parts that are not close together, as those of a disc are.
bool has_open_bodies(const PlantForm &form, const FormPlan &plan);

/// Draws parts on the ground that carry others with `rows` segments at least, so that skins that bend along a curve do
/// not leave what they carry. It may exceed the budget of the plan.
void divide_carriers(const PlantForm &form, int rows, FormPlan &plan);

} // namespace undergrowth

#pragma once

#include "form/plant_form.hpp"
#include "mesh/form_measure.hpp"
#include "mesh/part_detail.hpp"

#include <vector>

namespace undergrowth {

/// The most vertices of a plant of parts at a level: 792, 198, 50, 22, 12 for 12, 6, 3, 2, 1 vertical segments.
int vertex_budget(int lod);

/// Finer levels draw petals, leaves and bells as rounded as what fills the picture should be.
inline constexpr int FINEST_USUAL_LOD = 12;

/// How finely a body is drawn (mesh/form_body.hpp).
struct BodyDetail {
	int sides = 0;
	int rings = 1; ///< Of a whorl, 1 or 2; others have one.
};

/// How the parts of one group are drawn at one level.
struct GroupPlan {
	PartDetail detail;
	float kept = 1.0f; ///< Share of its parts, by rank; 0: none.
	/// Of the one body that stands for all parts on a carrier and whatever they carry; without sides parts are parts.
	BodyDetail body;
};

/// What is drawn of a form at one level.
struct FormPlan {
	enum Fate : uint8_t {
		drawn, ///< As a part.
		merged, ///< In a body.
		dropped,
	};
	std::vector<GroupPlan> groups;
	std::vector<Fate> fates; ///< Of each placed part.
	std::vector<int> bodies; ///< Of each placed part that is merged the number of its body, from 0; else -1.
	int body_count = 0;
	/// m² that each group is to show from the side, on the mean, as all of its parts do (FormMeasure); of what is
	/// dropped altogether those who look most like it show the rest. 0: nothing of it is drawn.
	std::vector<float> shown;
	bool is_cut = false; ///< Something is drawn coarser than parts are.
	MeshCounts counts;
};

/// What the body costs that stands for a group on one carrier.
MeshCounts count_body(const PartGroup &group, const BodyDetail &detail);

/// Decides what is left away so that the mesh has at most `budget` vertices, 12 or more. Step by step it takes what
/// changes the silhouette least for each vertex saved: details of many small parts first (they become pyramids, then
/// one dome or spindle in their mean colour), then columns, rows, parts by rank, and the stem's roundness last.
FormPlan plan_form(const PlantForm &form, const FormMeasure &measure, int budget);

} // namespace undergrowth

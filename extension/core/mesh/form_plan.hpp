#pragma once

#include "form/plant_form.hpp"
#include "mesh/form_measure.hpp"
#include "mesh/part_detail.hpp"

#include <vector>

namespace undergrowth {

/// Max vertices of a plant of parts at a level: 792, 198, 50, 22, 12 for 12, 6, 3, 2, 1 vertical segments.
int vertex_budget(int lod);

/// Levels above this draw petals, leaves and bells with the roundness of a plant that fills the picture.
inline constexpr int FINEST_USUAL_LOD = 12;

/// Level of detail of a body (mesh/form_body.hpp).
struct BodyDetail {
	int sides = 0;
	int rings = 1; ///< 1 or 2 for a whorl; 1 for all other layouts.
};

/// Level of detail of the parts of one group.
struct GroupPlan {
	PartDetail detail;
	float kept = 1.0f; ///< Fraction of its parts that is drawn, by rank; 0: none.
	/// Of the body that replaces all parts on a carrier and everything that they carry. Without sides, the parts are
	/// drawn as parts.
	BodyDetail body;
};

/// The units that one level draws of a form.
struct FormPlan {
	enum Fate : uint8_t {
		drawn, ///< As a part.
		merged, ///< In a body.
		dropped,
	};
	std::vector<GroupPlan> groups;
	std::vector<Fate> fates; ///< Of each placed part.
	std::vector<int> bodies; ///< By placed part: number of its body, from 0, or -1 if it is not merged.
	int body_count = 0;
	/// Area (m²) that each group must show from the side, on average: that of all its parts (FormMeasure). Dropped
	/// groups add theirs to the group that looks most like them. 0: nothing of the group is drawn.
	std::vector<float> shown;
	bool is_cut = false; ///< True if something is drawn coarser than as parts.
	MeshCounts counts;
};

/// Vertices and indices of the body that replaces a group on one carrier.
MeshCounts count_body(const PartGroup &group, const BodyDetail &detail);

/// Decides what to leave out so that the mesh has at most `budget` vertices, 12 or more. Each step changes the
/// silhouette least for each vertex that it saves. First the details of many small parts are reduced: they become
/// pyramids, then one dome or spindle in their mean colour. Columns, rows and parts by rank follow; the roundness of
/// the stem is last.
FormPlan plan_form(const PlantForm &form, const FormMeasure &measure, int budget);

} // namespace undergrowth

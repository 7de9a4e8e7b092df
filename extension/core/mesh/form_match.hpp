#pragma once

#include "mesh/form_measure.hpp"
#include "mesh/vertex_format.hpp"

#include <vector>

namespace undergrowth {

/// One part or body of a mesh: from its first vertex and index to those of the next.
struct WrittenUnit {
	int vertex = 0;
	int index = 0;
	float near_share = 1.0f; ///< Of its triangles that are seen.
	bool is_flower = false; ///< Or of one: it keeps its size beside the rest.
	float most = 1e9f; ///< Times as wide as it was written.
};

/// Makes what was written of a form look like the form: each unit so much wider or narrower, along the ground also more
/// one way than across, that the outlines from all sides are those of the plant with all of its parts; then all colours
/// so much lighter or darker that the mean is. Reached with eight seeds
/// of each ready species, at 792 to 12 vertices: 1 % a side on the mean and some 7 % at the worst, on pictures of 2048
/// rows; 5 % is missed by about one mesh of a hundred, thin plants whose heads are lower than the dots that outlines
/// are matched on (mesh/silhouette.cpp), beside which they are within 5 %. Colours: ΔE 2. `units` end with
/// one that begins where the mesh ends.
void match_form(const FormMeasure &measure, const std::vector<WrittenUnit> &units, const FormBuffers &mesh);

} // namespace undergrowth

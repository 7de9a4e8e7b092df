#pragma once

#include "form/part.hpp"
#include "mesh/plant_mesh.hpp"

#include <vector>

namespace undergrowth {

/// Level of detail of one part.
struct PartDetail {
	int columns = 2; ///< Vertices across a blade; sides of an axis or bead, where 2 draws a flat ribbon.
	int rows = 1; ///< Spans along the part.

	bool operator==(const PartDetail &other) const { return columns == other.columns && rows == other.rows; }
};

/// Details from the finest to the coarsest. `is_close`: those of a plant that fills the picture come first.
std::vector<PartDetail> details_of(const Part &part, bool is_close = false);

/// Vertices, and three indices per triangle.
MeshCounts count_part(const Part &part, const PartDetail &detail);

/// Estimated difference of the drawn part from the true one, as a fraction of its area: chords for arcs, polygons for
/// circles and straight edges for round ones. It orders what to leave out first.
float error_of(const Part &part, const PartDetail &detail);

/// True if the part is as wide everywhere as its ends suggest.
bool is_even(const Part &part);
/// True if the part ends in one vertex: a point, or the middle of its lid.
bool ends_in_point(const Part &part);
/// True if a closed tube has a lid because its tip is still wide.
bool has_lid(const Part &part, const PartDetail &detail);
/// True if the detail follows each tooth of a blade's edge.
bool shows_teeth(const Part &part, const PartDetail &detail);

/// Offsets of the rows + 1 rows of a part. For a bead, only those between its two poles.
std::vector<float> row_offsets(const Part &part, const PartDetail &detail);

} // namespace undergrowth

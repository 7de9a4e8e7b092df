#pragma once

#include "form/part.hpp"
#include "mesh/plant_mesh.hpp"

#include <vector>

namespace undergrowth {

/// Detail of one part.
struct PartDetail {
	int columns = 2; ///< Blade: vertices across it. Axis or bead: sides; 2 draws it as a flat ribbon.
	int rows = 1; ///< Segments along it.

	bool operator==(const PartDetail &other) const { return columns == other.columns && rows == other.rows; }
};

/// Returns all details from finest to coarsest. `is_close`: close-up details first.
std::vector<PartDetail> details_of(const Part &part, bool is_close = false);

/// Returns its vertices, and three indices per triangle.
MeshCounts count_part(const Part &part, const PartDetail &detail);

/// Returns the estimated difference of the drawn part to the true one, as a fraction of its area. It includes chords
/// for arcs, polygons for circles and straight edges for round ones. Plans order their steps by it.
float error_of(const Part &part, const PartDetail &detail);

/// True if the width is linear between its ends.
bool is_even(const Part &part);
/// True if the part ends in one vertex: a point, or the middle of its lid.
bool ends_in_point(const Part &part);
/// True if the detail draws a slender blade with a blunt tip as a triangle of its area.
bool is_spike(const Part &part, const PartDetail &detail);
/// True if a closed tube has a lid, because its tip is still wide.
bool has_lid(const Part &part, const PartDetail &detail);
/// True if the detail follows each tooth of a blade's edge.
bool shows_teeth(const Part &part, const PartDetail &detail);

/// Returns the offsets of the rows + 1 rows of a part. For a bead, those between its poles are fewer.
std::vector<float> row_offsets(const Part &part, const PartDetail &detail);

} // namespace undergrowth

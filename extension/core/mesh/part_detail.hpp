#pragma once

#include "form/part.hpp"
#include "mesh/plant_mesh.hpp"

#include <vector>

namespace undergrowth {

/// How finely one part is drawn.
struct PartDetail {
	int columns = 2; ///< Of a blade: vertices across it. Of an axis or bead: sides; 2 draws it as a flat ribbon.
	int rows = 1; ///< Spans along it.

	bool operator==(const PartDetail &other) const { return columns == other.columns && rows == other.rows; }
};

/// From the finest to the coarsest; `is_close`: with those of a plant that fills the picture before the usual ones.
std::vector<PartDetail> details_of(const Part &part, bool is_close = false);

/// What it costs: vertices, and three indices a triangle.
MeshCounts count_part(const Part &part, const PartDetail &detail);

/// How far the drawn part is from the true one, as a share of its area: chords for arcs, polygons for circles and
/// straight edges for round ones. An estimate that orders what is to be left away.
float error_of(const Part &part, const PartDetail &detail);

/// Whether it is as wide all along as its ends say.
bool is_even(const Part &part);
/// Whether the part ends in one vertex: a point, or the middle of the lid that closes it.
bool ends_in_point(const Part &part);
/// Whether a closed tube has a lid at its tip, since it is still wide there.
bool has_lid(const Part &part, const PartDetail &detail);
/// Whether the detail follows each tooth of a blade's edge.
bool shows_teeth(const Part &part, const PartDetail &detail);

/// The offsets of the rows + 1 rows of a part; of a bead those between its two poles are less.
std::vector<float> row_offsets(const Part &part, const PartDetail &detail);

} // namespace undergrowth

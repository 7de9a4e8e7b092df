#pragma once

#include <glm/vec2.hpp>

#include <vector>

namespace undergrowth {

/// A polygon in a field's ground plane: (x, z) in metres, either way around, closed by itself. Where its edges cross,
/// the parts that it goes around an even number of times are outside.
using Polygon = std::vector<glm::vec2>;

/// Coordinates of areas go up to this (m): beyond it, single precision is coarser than a centimetre.
inline constexpr float FARTHEST_COORDINATE = 1.0e5f;

enum class AreaFault {
	none,
	too_few_points, ///< Fewer than three.
	not_finite,
	too_far, ///< Beyond FARTHEST_COORDINATE.
	no_area, ///< On a line, to 1e-6 of its length.
};

/// The first fault, in the order of the enumeration.
AreaFault find_area_fault(const Polygon &polygon);
/// One sentence for the author of the area.
const char *describe(AreaFault fault);

/// From -size/2 to size/2 around `centre`; no area where a size is 0. Negative sizes count as positive.
Polygon rectangle(const glm::vec2 &size, const glm::vec2 &centre = { 0.0f, 0.0f });

/// Whether a point is inside. Of points on an edge: on edges towards smaller x or z inside, on the others outside, so
/// that a point on the seam of two areas is in exactly one of them.
bool is_inside(const Polygon &polygon, const glm::vec2 &point);

/// m², > 0 where the polygon runs from +x to +z (clockwise seen from above with z towards the viewer).
double signed_area(const Polygon &polygon);
/// Sum of the edges' lengths (m).
double perimeter(const Polygon &polygon);

struct AreaBox {
	glm::vec2 low = { 0.0f, 0.0f };
	glm::vec2 high = { 0.0f, 0.0f };
};

/// On its lower sides included, on the others not.
bool is_in_box(const AreaBox &box, const glm::vec2 &point);

/// What is in both of two boxes; where nothing is, some side of it is below 0.
AreaBox common_box(const AreaBox &one, const AreaBox &other);

/// Around all places that are in one of two polygons and not in the other: around the edges that only one of them has,
/// but for those along x, which no place is beside. Some side of it is below 0 where they have the same ones.
AreaBox changed_box(const Polygon &one, const Polygon &other);

/// Both corners (0, 0) where there are no points.
AreaBox bounding_box(const Polygon &polygon);

} // namespace undergrowth

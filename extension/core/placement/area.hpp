#pragma once

#include <glm/vec2.hpp>

#include <vector>

namespace undergrowth {

/// A polygon in a field's ground plane: (x, z) in metres, of either orientation, implicitly closed. Even-odd rule:
/// parts with an even winding are outside.
using Polygon = std::vector<glm::vec2>;

/// Maximum coordinate of areas (m): beyond it single precision is coarser than a centimetre.
inline constexpr float FARTHEST_COORDINATE = 1.0e5f;

enum class AreaFault {
	none,
	too_few_points, ///< Fewer than three.
	not_finite,
	too_far, ///< Beyond FARTHEST_COORDINATE.
	no_area, ///< Points on a line, within 1e-6 of its length.
};

/// The first fault, in the order of the enumeration.
AreaFault find_area_fault(const Polygon &polygon);
/// One sentence for the user: the error and its remedy.
const char *describe(AreaFault fault);

/// From -size/2 to size/2 around `centre`; no area where a size is 0. Negative sizes count as positive.
Polygon rectangle(const glm::vec2 &size, const glm::vec2 &centre = { 0.0f, 0.0f });

/// True if a point is inside. Points on edges towards smaller x or z are inside, points on all other edges outside, so
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

/// Includes the lower sides, excludes the upper ones.
bool is_in_box(const AreaBox &box, const glm::vec2 &point);

/// Intersection of two boxes; a side is negative if it is empty.
AreaBox common_box(const AreaBox &one, const AreaBox &other);

/// Bounding box of the symmetric difference of two polygons: of the edges that only one of them has, except edges along
/// x. A side is negative if the polygons are equal.
AreaBox changed_box(const Polygon &one, const Polygon &other);

/// Both corners are (0, 0) without points.
AreaBox bounding_box(const Polygon &polygon);

} // namespace undergrowth

#include "plant/base_shape.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr double PLANE_TOLERANCE = 1e-4; // Of the ring's size.
constexpr double AREA_TOLERANCE = 1e-8; // Of the ring's squared size: for smaller areas rounding decides the sign.

glm::dvec2 at(const glm::vec3 *points, int i) {
	return { points[i].x, points[i].z };
}

/// Twice the signed area of a triangle, positive if it runs counter-clockwise from above. The z axis points towards the
/// viewer, which reverses the usual sign.
double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
	return (b.y - a.y) * (c.x - a.x) - (b.x - a.x) * (c.y - a.y);
}

bool in_box(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
	return p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
			p.y <= std::max(a.y, b.y);
}

/// True if the segments ab and cd have a point in common.
bool segments_meet(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
	const double c_side = turn(a, b, c);
	const double d_side = turn(a, b, d);
	const double a_side = turn(c, d, a);
	const double b_side = turn(c, d, b);
	if (((c_side > 0.0 && d_side < 0.0) || (c_side < 0.0 && d_side > 0.0)) &&
			((a_side > 0.0 && b_side < 0.0) || (a_side < 0.0 && b_side > 0.0))) {
		return true;
	}
	return (c_side == 0.0 && in_box(a, b, c)) || (d_side == 0.0 && in_box(a, b, d)) ||
			(a_side == 0.0 && in_box(c, d, a)) || (b_side == 0.0 && in_box(c, d, b));
}

/// True if the edge after `corner` runs back over the edge before it, or if either has no length.
bool folds_back(glm::dvec2 before, glm::dvec2 corner, glm::dvec2 after) {
	return turn(before, corner, after) == 0.0 && glm::dot(corner - before, after - corner) <= 0.0;
}

bool crosses_itself(const glm::vec3 *points, int count) {
	for (int i = 0; i < count; i++) {
		const glm::dvec2 a = at(points, i);
		const glm::dvec2 b = at(points, (i + 1) % count);
		if (folds_back(a, b, at(points, (i + 2) % count))) {
			return true;
		}
		// Edges i + 1 and i - 1 share a point with edge i.
		for (int j = i + 2; j < count && !(i == 0 && j == count - 1); j++) {
			if (segments_meet(a, b, at(points, j), at(points, (j + 1) % count))) {
				return true;
			}
		}
	}
	return false;
}

bool all_finite(const glm::vec3 *points, int count) {
	return std::all_of(points, points + count,
			[](const glm::vec3 &p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); });
}

/// The longer side of the ring's bounding box on the plane.
double ring_size(const glm::vec3 *points, int count) {
	glm::dvec2 low = at(points, 0);
	glm::dvec2 high = low;
	for (int i = 1; i < count; i++) {
		const glm::dvec2 p = at(points, i);
		low = { std::min(low.x, p.x), std::min(low.y, p.y) };
		high = { std::max(high.x, p.x), std::max(high.y, p.y) };
	}
	return std::max(high.x - low.x, high.y - low.y);
}

/// Twice the area, positive if the ring runs counter-clockwise from above.
double signed_area(const glm::vec3 *points, int count) {
	double sum = 0.0;
	for (int i = 1; i + 1 < count; i++) {
		sum += turn(at(points, 0), at(points, i), at(points, i + 1));
	}
	return sum;
}

} // namespace

RingFault find_ring_fault(const glm::vec3 *points, int count) {
	if (count < MIN_RING_POINTS) {
		return RingFault::too_few_points;
	}
	if (count > MAX_RING_POINTS) {
		return RingFault::too_many_points;
	}
	if (!all_finite(points, count)) {
		return RingFault::not_finite;
	}
	const double size = ring_size(points, count);
	if (std::any_of(points, points + count,
				[size](const glm::vec3 &p) { return std::abs(p.y) > PLANE_TOLERANCE * size; })) {
		return RingFault::not_planar;
	}
	const double area = signed_area(points, count);
	if (std::abs(area) <= AREA_TOLERANCE * size * size) {
		return RingFault::no_area;
	}
	if (area < 0.0) {
		return RingFault::clockwise;
	}
	return crosses_itself(points, count) ? RingFault::self_crossing : RingFault::none;
}

const char *describe(RingFault fault) {
	switch (fault) {
		case RingFault::none:
			return "The base shape is sound.";
		case RingFault::too_few_points:
			return "The base shape has fewer than 3 points: return at least 3 that go around the stem.";
		case RingFault::too_many_points:
			return "The base shape has more than 1024 points: return fewer; 4 to 64 are typical.";
		case RingFault::not_finite:
			return "The base shape has a point that is NaN or infinite: check for divisions by zero.";
		case RingFault::not_planar:
			return "The base shape has a point off the ground: set y to 0 in all of its points.";
		case RingFault::no_area:
			return "The base shape encloses no area: its points must not all lie on one line.";
		case RingFault::clockwise:
			return "The base shape is clockwise, seen from above: reverse the order of its points.";
		case RingFault::self_crossing:
			return "The base shape intersects or touches itself: order its points around the stem, and remove "
				   "duplicates.";
	}
	return "";
}

} // namespace undergrowth

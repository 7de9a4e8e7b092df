#pragma once

#include "form/part.hpp"

#include <glm/vec3.hpp>

namespace undergrowth {

// Points and normals of the surfaces of parts: blades (leaves, petals) and tubes (axes, beads). A surface point is
// separated into a term for the length and one for the width of the part, so that parts of one kind share their points
// at all sizes. Pure functions for any thread; positions are in the part's own axes.

/// A point of a part's surface and the directions of the surface there. In a part of length L and width W (m) the point
/// is at L·middle + W·aside.
struct SurfacePoint {
	glm::vec3 middle; ///< Point of the midrib at a length of 1.
	glm::vec3 along; ///< Unit tangent of the midrib.
	glm::vec3 aside; ///< From the midrib to the point, for a width of 1.
	glm::vec3 aside_slope; ///< Change of `aside` per offset.
	glm::vec3 around; ///< Across the surface: (L·along + W·aside_slope) × around is its normal. Not 0, any length.
};

/// Returns the unit normal at a point: that of the upper side of a blade, or the outward one of an axis or bead.
glm::vec3 surface_normal(const SurfacePoint &point, float length, float width);

/// Values that all points of a blade at one offset share. Offsets run from 0 at the base to 1 at the tip.
struct BladeRow {
	float offset;
	Midrib::Place place; ///< Turned by the blade's twist.
	glm::vec3 across_slope; ///< Change of the turned axes per offset.
	glm::vec3 up_slope;
	float half_width; ///< At a width of 1, teeth included.
	float half_width_slope;
	float wave; ///< Lift of the edge, in half-widths.
	float wave_slope;
};

/// Returns the row at `offset`. Without `with_teeth` the edge is smooth and has the mean width of the teeth.
BladeRow make_blade_row(const Part &part, const Midrib &midrib, float offset, bool with_teeth);

/// Values that all points of a blade at one position across it share. u runs from -1 at the left edge to 1 at the right
/// one. With fold φ and roll κ (rad) the cross-section is an arc with the length of the half-width:
/// x = ±(sin(φ + κ|u|) - sin φ)/κ and y = (cos φ - cos(φ + κ|u|))/κ.
struct BladeColumn {
	float u;
	float x;
	float y;
	float x_slope; ///< Per u.
	float y_slope;
};

BladeColumn make_blade_column(const BladeShape &blade, float u);

SurfacePoint blade_point(const BladeRow &row, const BladeColumn &column);

/// Values that all points of an axis or bead at one offset share.
struct TubeRing {
	float offset;
	Midrib::Place place;
	float radius; ///< At a width of 1.
	float radius_slope; ///< Per offset.
};

TubeRing make_tube_ring(const Part &part, const Midrib &midrib, float offset);

/// A position on the circumference of a tube of radius 1. `turn` runs from 0 to 1, clockwise as seen from the tip. x
/// points across, z down from the upper side.
struct TubeColumn {
	float turn;
	float x;
	float z;
	float x_slope; ///< Per radian, or per corner of a ring.
	float z_slope;
};

/// Returns `sides` columns, at least 3, at equal turns. If the axis has a cross-section of its own, returns the corners
/// of that section that are nearest to these turns.
std::vector<TubeColumn> make_tube_columns(const AxisShape &axis, int sides);

SurfacePoint tube_point(const TubeRing &ring, const TubeColumn &column);

} // namespace undergrowth

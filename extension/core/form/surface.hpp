#pragma once

#include "form/part.hpp"

#include <glm/vec3.hpp>

namespace undergrowth {

/// A point of a part's surface and how the surface runs there, taken apart by what makes it larger: a part of length L
/// and width W has it at L·middle + W·aside. So parts of one kind share their points whatever their sizes.
struct SurfacePoint {
	glm::vec3 middle; ///< Of the midrib, for a length of 1.
	glm::vec3 along; ///< Unit: where the midrib goes.
	glm::vec3 aside; ///< From the midrib to the point, for a width of 1.
	glm::vec3 aside_slope; ///< Change of `aside` per offset.
	glm::vec3 around; ///< Across the surface: (L·along + W·aside_slope) × around is its normal. Not 0, any length.
};

/// The unit normal of a point: of a blade the upper side's, of an axis or bead outward.
glm::vec3 surface_normal(const SurfacePoint &point, float length, float width);

/// What a row of a blade shares.
struct BladeRow {
	float offset;
	Midrib::Place place; ///< Turned by the blade's twist.
	glm::vec3 across_slope; ///< Change of the turned axes per offset.
	glm::vec3 up_slope;
	float half_width; ///< Of a width of 1, teeth included.
	float half_width_slope;
	float wave; ///< Lift of the edge, in half-widths.
	float wave_slope;
};

/// `with_teeth`: else the blade's edge is even, as wide as the teeth are on the mean.
BladeRow make_blade_row(const Part &part, const Midrib &midrib, float offset, bool with_teeth);

/// What a column of a blade shares: u = -1 at the left edge, 1 at the right one. Cross-section with fold φ and roll κ:
/// x = ±(sin(φ + κ|u|) - sin φ)/κ and y = (cos φ - cos(φ + κ|u|))/κ, an arc of the half-width's length.
struct BladeColumn {
	float u;
	float x;
	float y;
	float x_slope; ///< Per u.
	float y_slope;
};

BladeColumn make_blade_column(const BladeShape &blade, float u);

SurfacePoint blade_point(const BladeRow &row, const BladeColumn &column);

/// What a ring of an axis or a bead shares.
struct TubeRing {
	float offset;
	Midrib::Place place;
	float radius; ///< Of a width of 1.
	float radius_slope; ///< Per offset.
};

TubeRing make_tube_ring(const Part &part, const Midrib &midrib, float offset);

/// A way round a tube of radius 1: `turn` from 0 to 1 runs clockwise as seen from the tip. x goes across, z down from
/// the upper side.
struct TubeColumn {
	float turn;
	float x;
	float z;
	float x_slope; ///< Per radian, or per corner of a ring.
	float z_slope;
};

/// `sides` columns, at least 3, at equal turns; of a ring those nearest to these.
std::vector<TubeColumn> make_tube_columns(const AxisShape &axis, int sides);

SurfacePoint tube_point(const TubeRing &ring, const TubeColumn &column);

} // namespace undergrowth

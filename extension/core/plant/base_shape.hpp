#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace undergrowth {

/// Fewest and most points of a ring, and fewest and most vertical segments of a plant.
inline constexpr int MIN_RING_POINTS = 3;
inline constexpr int MAX_RING_POINTS = 1024;
inline constexpr int MIN_LOD = 1;
inline constexpr int MAX_LOD = 256;

/// The thesis's circle (snippet 2.7): max(4, lod) points, point i at (-cos a, sin a)·radius with a = 2πi/n.
/// At most MAX_RING_POINTS.
std::vector<glm::vec2> circle_ring(int lod, double radius = 0.3);

/// A parallelogram, the thesis's cross-section of grass (section 2.2): `width` along x, `depth` along z, the far side
/// shifted by `skew` along x. Always four points.
std::vector<glm::vec2> parallelogram_ring(float width, float depth, float skew);

/// A circle with `lobes` bulges (petals, stem ridges): radius·(1 + bulge·cos(lobes·a)). It has at least two points for
/// each half lobe, so that coarse levels have the same number of lobes, and at most MAX_RING_POINTS.
/// `lobes` in [1, 200], `bulge` in [0, 0.9]; without a bulge it is circle_ring().
std::vector<glm::vec2> lobed_ring(int lod, double radius, int lobes, double bulge);

/// Faults of a ring.
enum class RingFault {
	none,
	too_few_points,
	too_many_points,
	not_finite,
	not_planar, ///< A point lies off the plane y = 0 by more than 1e-4 of the ring's size.
	no_area,
	clockwise,
	self_crossing, ///< Two edges cross or touch, or two points coincide.
};

/// The first fault of `points[0 .. count)`, in the order of the enumeration. O(count²) in the worst case.
RingFault find_ring_fault(const glm::vec3 *points, int count);

/// One sentence for the author of the ring: what is wrong and what to do.
const char *describe(RingFault fault);

} // namespace undergrowth

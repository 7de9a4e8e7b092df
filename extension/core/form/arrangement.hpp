#pragma once

#include "form/midrib.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace undergrowth {

/// rad: a full turn divided by the golden ratio squared, 137.508°; the divergence of most spirals (Vogel 1979;
/// Prusinkiewicz and Lindenmayer, The Algorithmic Beauty of Plants, ch. 4).
inline constexpr float GOLDEN_ANGLE = 2.39996323f;

enum class Layout {
	along, ///< At nodes along what carries them: spiral, in two ranks, crosswise, in whorls.
	whorl, ///< Around the tip of what carries them.
	disc, ///< Over a disc or a cap of a sphere on the tip (Vogel 1979), from flat to a whole sphere.
	ground, ///< Over a flat disc on the ground, as a tuft or a rosette.
};

/// A number that runs from the first part to the last.
struct Span {
	float first = 0.0f;
	float last = 0.0f;

	float at(float t) const { return first + (last - first) * t; }
};

/// Number and placement of parts on each carrier.
struct Arrangement {
	Layout layout = Layout::along;
	int count_min = 1; ///< 0 to 4096; each carrier draws its count from this range, by the seed.
	int count_max = 1; ///< At least 1. With count_min = 0 some plants lack these parts.
	float from = 0.0f; ///< Along: the span of offsets on the carrier, 0 to 1.
	float to = 1.0f;
	int per_node = 1; ///< Along: parts at one node, 1 to 64.
	float turn = GOLDEN_ANGLE; ///< Along: rad from node to node. π: two ranks; π/2 with two a node: crosswise.
	float phase = 0.0f; ///< rad, of the first part about the carrier.
	Span angle; ///< rad from the carrier's direction; 0 continues it, π/2 is perpendicular.
	Span scale = { 1.0f, 1.0f }; ///< Of the part's size, 0.001 to 1000.
	std::vector<float> angles; ///< Replaces `angle`: samples at equal steps from first to last; empty, or at least 2.
	std::vector<float> scales; ///< The same for `scale`.
	float radius = 0.0f; ///< m, 0 to 10: of the whorl, the disc, the tuft. A disc above a half sphere: of its sphere.
	float dome = 0.0f; ///< Disc: rad, 0 (flat) to π (a whole sphere): from its middle to its rim.
	bool level_tops = false; ///< Disc: stalks grow longer towards the rim, so that all end at one height (corymb).
	/// True: upper sides face as the carrier's does, so that all parts lie in one plane, like a fern's leaflets.
	/// False: they face along the carrier, like leaves on a stem.
	bool flat = false;
	Span tilt; ///< Ground: rad from upright, from the middle of the disc to its rim; outward.
	float swept = 0.0f; ///< Ground: 0: parts point in all directions; 1: all to the plant's front (+z).
	float deviation = 0.0f; ///< rad, 0 to 1.5: maximum random turn of each part.

	/// Angle and scale at `t`, from 0 (first part) to 1 (last part).
	float angle_at(float t) const;
	float scale_at(float t) const;
};

/// Why it cannot grow and the remedy, as in find_part_fault().
std::string find_arrangement_fault(const Arrangement &arrangement);

/// A part's own axes: along the part at its base, outward from its carrier; x = along × outward. Orthonormal.
struct PartAxes {
	glm::vec3 x;
	glm::vec3 along;
	glm::vec3 outward;
};

/// Placement of one part on its carrier.
struct Seat {
	float offset = 1.0f; ///< On the carrier's midrib.
	float way = 0.0f; ///< 0 the first, 1 the last part, at the middle of its share; on discs from middle to rim.
	float azimuth = 0.0f; ///< rad about the carrier.
	float tilt = 0.0f; ///< rad from the carrier's direction, deviations included.
	float away = 0.0f; ///< m from the carrier's midrib.
	float lift = 0.0f; ///< m along the carrier beyond the offset.
	float stretch = 1.0f; ///< Of the part's length.
};

/// Part `i` of `count` by the arrangement's formula. `seed` chooses its deviation.
Seat seat_of(const Arrangement &arrangement, int i, int count, uint64_t seed);

/// Number of parts on one carrier.
int count_of(const Arrangement &arrangement, uint64_t seed);

/// Axes of a part on a carrier. All axes are in the plant's.
PartAxes turn_into(const PartAxes &carrier, float azimuth, float tilt);

/// The part's axes, turned about the part until its upper side faces as the carrier's does, as far as possible.
PartAxes turn_level(const PartAxes &part, const PartAxes &carrier);

} // namespace undergrowth

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

/// How many parts stand on each of those that carry them, and where.
struct Arrangement {
	Layout layout = Layout::along;
	int count_min = 1; ///< 0 to 4096; each carrier has its own count between the two, by the seed.
	int count_max = 1; ///< From 1 on. With a least count of 0 some plants have what others lack.
	float from = 0.0f; ///< Along: the span of offsets on the carrier, 0 to 1.
	float to = 1.0f;
	int per_node = 1; ///< Along: parts at one node, 1 to 64.
	float turn = GOLDEN_ANGLE; ///< Along: rad from node to node. π: two ranks; π/2 with two a node: crosswise.
	float phase = 0.0f; ///< rad, of the first part about the carrier.
	Span angle; ///< rad from the carrier's direction; 0 goes on with it, π/2 stands off.
	Span scale = { 1.0f, 1.0f }; ///< Of the part's size, 0.001 to 1000.
	std::vector<float>
			angles; ///< Samples at equal steps from first to last that stand for `angle`; empty or 2 and more.
	std::vector<float> scales; ///< The same for `scale`.
	float radius = 0.0f; ///< m, 0 to 10: of the whorl, the disc, the tuft. A disc above a half sphere: of its sphere.
	float dome = 0.0f; ///< Disc: rad, 0 (flat) to π (a whole sphere): from its middle to its rim.
	bool level_tops = false; ///< Disc: stalks grow longer towards the rim, so that all end at one height (corymb).
	/// Upper sides look where the carrier's does, so that all lie in one plane, as a fern's leaflets. Else they look
	/// along the carrier, as a leaf's on its stem.
	bool flat = false;
	Span tilt; ///< Ground: rad from upright, from the middle of the disc to its rim; outward.
	float deviation = 0.0f; ///< rad, 0 to 1.5: how far each part may turn from where it belongs.

	/// Angle and scale at the way `t` from the first part to the last.
	float angle_at(float t) const;
	float scale_at(float t) const;
};

/// What keeps it from growing and what to do, as find_part_fault().
std::string find_arrangement_fault(const Arrangement &arrangement);

/// A part's own axes: along the part at its base, outward from its carrier; x = along × outward. Unit length, upright
/// on each other.
struct PartAxes {
	glm::vec3 x;
	glm::vec3 along;
	glm::vec3 outward;
};

/// Where one part stands on its carrier.
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

/// How many parts one carrier gets.
int count_of(const Arrangement &arrangement, uint64_t seed);

/// A part's axes on a carrier whose midrib and own axes are given in the plant's.
PartAxes turn_into(const PartAxes &carrier, float azimuth, float tilt);

/// The part's axes turned about the part until its upper side looks where the carrier's does, as far as it can.
PartAxes turn_level(const PartAxes &part, const PartAxes &carrier);

} // namespace undergrowth

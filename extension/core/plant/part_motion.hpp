#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace undergrowth {

/// How one part of a plant swings on its carrier (motion/part_bend.hpp has the law).
struct PartMotion {
	float frequency = 3.0f; ///< Hz, above 0.
	float damping_ratio = 0.12f; ///< 1 is critical.
	float phase = 0.0f; ///< 0 to 1: phase of its swing at the clock's start.
	/// Unit, x and z of the plant's axes: the side of its carrier on which it hangs. (0, 0): on none, as a flower's
	/// head.
	glm::vec2 side = { 0.0f, 0.0f };
	/// A bend: how far it may turn outward, that is down, before it meets the ground. 0 to 1.
	float room = 1.0f;

	bool is_head() const { return side.x == 0.0f && side.y == 0.0f; }
};

/// A swing that carries other parts: that of a branch under its twigs.
struct CarrierSwing {
	glm::vec3 pivot = { 0.0f, 0.0f, 0.0f }; ///< m.
	float weight = 0.0f; ///< Fraction of its swing at the place that carries, 0 to 1.
	PartMotion swing;
};

/// Maximum number of swings on the swing of a branch: those of a twig and of a leaf on it.
inline constexpr int MAX_INNER_SWINGS = 2;

/// Period of the clock of swings (s). Frequencies are multiples of 1/SWING_PERIOD, so that swings are continuous when
/// the clock wraps.
inline constexpr double SWING_PERIOD = 128.0;

/// A swing in vertex data: two integers from -2048 to 2047, which half floats represent exactly. Shaders and skeletons
/// both read them.
struct PartMotionCode {
	/// 32 · pace + damping - 2048. Pace p from 0 to 127: (16 + p mod 16) · 2^⌊p/16⌋ swings in SWING_PERIOD, that is
	/// 0.125 to 31 Hz within 3 %. Damping d from 0 to 31: the ratio 2 · (d/31)².
	float pace = -2048.0f;
	/// 128 · phase + 4 · side + room - 2048. Phase in 32nds; side 1 to 31: (side - 1)/31 of a turn from +x towards +z,
	/// 0: none; room 0 to 3: 0.02 · 4^room, the largest that is no larger.
	float place = -2048.0f;
};

PartMotionCode encode_part_motion(const PartMotion &swing);
PartMotion decode_part_motion(const PartMotionCode &code);

/// A bone for the swing of a part, a head, or a few neighbouring parts.
struct PartBone {
	glm::vec3 origin; ///< m, at rest, in the plant's axes; its own axes are the plant's.
	glm::vec3 pivot; ///< m, about which the swing turns it.
	float stem_offset; ///< Offset on the stem to which it is attached.
	float weight; ///< Fraction of its part's swing, 0 to 1.
	int outer_of = -1; ///< Index of the bone of the inner half of the same part; -1: the bone has the whole part.
	int carried_by = -1; ///< Index of the bone of a branch that carries its part; -1: the stem does.
	CarrierSwing carrier; ///< The swing of that branch.
	PartMotion swing;
};

} // namespace undergrowth

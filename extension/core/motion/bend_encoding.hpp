#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

namespace undergrowth {

/// Encoding of a plant's bend for the graphics card: the stereographic image s = (x, z)/(1 + y) of the unit direction
/// from root to tip, as two half floats (IEEE 754 binary16, nearest, ties to even). Upright is (0, 0), the horizon the
/// unit circle; within it neighbouring codes are less than 0.001 rad apart. Without a square root, d = (2·s.x, 1 - n,
/// 2·s.y)/(1 + n) with n = dot(s, s), and the shortest turn from +y to d is the quaternion (s.y, 0, -s.x, 1)/sqrt(1 +
/// n).
///
/// motion/kernel_bends.inc encodes whole pages to the same bits, and undergrowth_bend() in
/// addons/undergrowth/shaders/undergrowth_bend.gdshaderinc decodes them. Change all three together.
using Bend = uint32_t; ///< s.x in the low half, s.y (of the axis z) in the high one.

/// The half float nearest to `value`; infinite beyond 65,504; NaN remains NaN.
uint16_t to_half(float value);
/// Exact.
float from_half(uint16_t half);

/// `direction`: unit; straight down becomes the largest code.
Bend encode_bend(const glm::vec3 &direction);
glm::vec2 stereographic(Bend bend);
/// The code of a stereographic image.
Bend pack_bend(const glm::vec2 &s);
/// The unit direction whose stereographic image is `s`.
glm::vec3 from_stereographic(const glm::vec2 &s);
/// Unit.
glm::vec3 decode_bend(Bend bend);

/// Interpolation between two bends, and their difference.
struct BendWay {
	glm::vec2 bend;
	glm::vec2 change;
};

/// Interpolates from pair[0] to pair[1] by `share`.
BendWay bend_way(const Bend *pair, float share);

} // namespace undergrowth

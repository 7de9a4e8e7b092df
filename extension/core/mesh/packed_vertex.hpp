#pragma once

#include "mesh/vertex_format.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>

namespace undergrowth {

/// The attributes of a vertex that fields pack, as in mesh/vertex_format.hpp.
struct VertexAttributes {
	glm::vec3 normal = { 0.0f, 1.0f, 0.0f };
	glm::vec3 tangent = { 1.0f, 0.0f, 0.0f };
	glm::vec2 uv = { 0.0f, 0.0f };
	glm::vec4 custom0 = { 0.0f, 0.0f, 0.0f, 0.0f };
	glm::vec4 custom1 = { 0.0f, 0.0f, 0.0f, 0.0f };
	glm::vec4 custom2 = { 0.0f, 0.0f, 0.0f, 0.0f };
	float height = 0.0f; ///< CUSTOM3.x.
	float stem_place = 0.0f; ///< CUSTOM3.y.
};

/// The same in two attributes of four floats. For a graphics card each attribute costs about the same, whatever its
/// size. undergrowth_packed.gdshaderinc reads it.
///
/// A word has 30 bits, from the lowest to the highest:
///
/// 0: stem offset (16, in 1/32768), stem place (14, in 1/16384)
/// 1: height (15, half float without its sign), length of CUSTOM2.xyz (15, the same)
/// 2: direction of CUSTOM2.xyz (10 + 10, octahedral), whole part of CUSTOM0.z (10)
/// 3: own weight (8), leafiness (6), rank (8, in 1/256), angle of the tangent about the normal (8, in 1/256 turn)
/// 4, 5, 6: x, y and z of the pivot (16, half floats), each with: pace (12), place (12), x of UV (10)
/// 7: y of UV (10), normal (10 + 10, octahedral)
///
/// Bits 29 and 30 of a float differ. So no word is a NaN or denormal, which graphics cards may change.
struct PackedVertex {
	static constexpr int WORDS = 8;

	float words[WORDS];
};

/// A swing on a swing (InnerVertex) in three floats. Words from the lowest bit to the highest: x, y and z of the pivot
/// (16, half floats), each with: pace (12), place (12), weight (8). undergrowth_packed.gdshaderinc reads it.
struct PackedSwing {
	static constexpr int WORDS = 3;

	float words[WORDS];
};

PackedSwing pack_swing(const InnerVertex &swing);

/// Packs finite attributes. Those outside of their range are clamped: offsets to 2, codes of CUSTOM0.z to 1023.
PackedVertex pack_vertex(const VertexAttributes &of);

} // namespace undergrowth

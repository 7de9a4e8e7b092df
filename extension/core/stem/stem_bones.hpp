#pragma once

#include "stem/stem_constants.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace undergrowth {

/// A place on a bent stem.
struct StemPlace {
	glm::vec3 centre; ///< In stem lengths, from the root.
	glm::vec2 bend; ///< Stereographic image of the stem's direction there, in the rest's frame.
};

/// How far the stem is bent at x, 0 at the root to 1 at the tip. `amplitudes`: one of each mode.
glm::vec2 stem_bend(const StemConstants &stem, const glm::vec2 *amplitudes, float x);
/// Where x is: the stem's direction integrated from the root at three places (Gauss), within 0.3 % of the length up to
/// a tip angle of 70°. x beyond the ends counts as the end. The vertex shader computes the same.
StemPlace stem_place(const StemConstants &stem, const glm::vec2 *amplitudes, float x);

/// A link between two joints, which the bone at its lower end turns.
struct StemLink {
	glm::vec3 start; ///< In stem lengths.
	glm::vec3 direction; ///< Unit.
	glm::vec4 turn; ///< Unit quaternion, w last: the shortest turn from upright to `direction`.
};

/// The bones of a stem: as many links as it has joints, all of the same length, 1 in all within 1e-5, each along the
/// mean of two directions of the stem beside it. The first starts at the root. Returns where the last ends.
glm::vec3 stem_links(const StemConstants &stem, const glm::vec2 *amplitudes, StemLink *links);

/// Four bones and their weights, which sum to 1. Bone 0 is the root's, which never moves; bone j turns link j, 1 to
/// `joints`.
struct StemBinding {
	int bones[4];
	float weights[4];
};

/// Binding of a vertex at x along the stem: a cubic B-spline over the links, so that the skin bends as smoothly as the
/// stem. Above the tip: the last link alone. At and below the ground: the root alone.
StemBinding bind_to_stem(int joints, float x);

} // namespace undergrowth

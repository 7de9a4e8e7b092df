#pragma once

#include "plant/part_swing.hpp"
#include "stem/stem_constants.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace undergrowth {

/// What a plant's stem does as it is drawn, in the plant's own axes. Bends are stereographic images
/// (motion/bend_encoding.hpp).
struct StemMotion {
	glm::vec2 bend = { 0.0f, 0.0f };
	glm::vec2 rate = { 0.0f, 0.0f }; ///< 1/s, of the bend: the change of the last step over its length.
	glm::vec2 rest = { 0.0f, 0.0f }; ///< The bend in calm air.
	glm::vec2 second = { 0.0f, 0.0f }; ///< What of it is a bending stem's second mode, in the frame of its rest.
	float clock = 0.0f; ///< 0 to 1: the share of SWING_PERIOD that has gone by.
};

/// How far a part bends beside its stem: a stereographic image as well, of its tip's turn about its pivot, at most
/// MOST_PART_BEND. It follows from what the stem does; nothing is simulated and nothing remembered:
///
/// - the wind that bends the stem presses the part the same way, most where it comes against the part from outside
///   and least on the lee side,
/// - it lags behind the stem, by a time that grows with its damping and falls with its frequency,
/// - it flutters at about its frequency and its own phase, more the farther the stem is from its rest, most on the lee
///   side, and less the more it is damped,
/// - stiff parts (of high frequency) do all of it less, and none folds far in towards its stem or down into the ground.
///
/// So parts of a stem at rest are still, and come to rest with it. Numbers of any size give a bound, finite one. The
/// mirror for fields is undergrowth_part_bend() in addons/undergrowth/shaders/undergrowth_swing.gdshaderinc: who
/// changes one changes both.
glm::vec2 part_bend(const PartSwing &part, const StemMotion &stem);

/// About 44°: of a tip's turn as seen from the pivot. The tip itself points twice as far.
inline constexpr float MOST_PART_BEND = 0.4f;

/// Turns `v` by a bend, as undergrowth_turned() in the shaders.
glm::vec3 turned(const glm::vec3 &v, const glm::vec2 &bend);

/// Where a point of a part goes whose own bend is `bend`; `way` leads from the pivot to it. `weight`: its own bend
/// weight, 0 at the attachment and 1 at the tip. A straight blade becomes an arc of a circle of the same length.
glm::vec3 bent_way(const glm::vec3 &way, const glm::vec2 &bend, float weight);

/// The bend of a place of a part whose tip bends so: its angle is `weight` times the tip's. Within 1e-4.
glm::vec2 bend_at(const glm::vec2 &tip, float weight);

/// How much shorter the straight way to a place is than the arc, where the way has turned by this bend.
float arc_share(const glm::vec2 &bend);

/// A turn, a size and a shift: what a bone does to all that is bound to it.
struct PartPose {
	glm::vec4 turn = { 0.0f, 0.0f, 0.0f, 1.0f }; ///< Unit quaternion, w last.
	float size = 1.0f;
	glm::vec3 shift = { 0.0f, 0.0f, 0.0f }; ///< m: where the plant's root would go.
};

/// Of a bone, in the plant's axes. Linear blend skinning from the stem to it, and on to the bone of the outer half,
/// shows what shaders show, to the first order of the bend.
PartPose pose_of(const PartBone &bone, const StemMotion &stem);

/// How a stem stands that bends along its length, in the plant's axes.
struct StandingStem {
	const StemConstants &constants;
	float height; ///< m, of the plant.
	glm::vec2 rest; ///< The bend in calm air.
	glm::vec2 amplitudes[MOST_STEM_MODES] = {}; ///< In the frame of the rest.

	StandingStem(const StemConstants &stem, float plant_height, const StemMotion &motion);
	/// Where the stem has brought what stands at `place` (m) and hangs on it at the offset x, and how far it has turned
	/// that: as undergrowth_bend_stem() in the shaders.
	glm::vec3 place_of(const glm::vec3 &place, float x) const;
	/// Unit quaternion, w last.
	glm::vec4 turn_at(float x) const;

private:
	glm::vec2 lean_at(float x) const;
};

/// Of a bone on such a stem: as pose_of() above.
PartPose pose_of(const PartBone &bone, const StemMotion &motion, const StandingStem &stem);

} // namespace undergrowth

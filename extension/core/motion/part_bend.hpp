#pragma once

#include "plant/part_motion.hpp"
#include "stem/stem_constants.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace undergrowth {

/// Drawn motion of a plant's stem, in the plant's own axes. Bends are stereographic images
/// (motion/bend_encoding.hpp).
struct StemMotion {
	glm::vec2 bend = { 0.0f, 0.0f };
	glm::vec2 rate = { 0.0f, 0.0f }; ///< 1/s, of the bend: the change of the last step over its length.
	glm::vec2 rest = { 0.0f, 0.0f }; ///< The bend in calm air.
	glm::vec2 second = { 0.0f, 0.0f }; ///< Part of the bend that is the second mode, in the frame of the rest.
	float clock = 0.0f; ///< 0 to 1: phase within SWING_PERIOD.
	float air = 0.0f; ///< m/s, around the plant (PartAir).
	float stirred = 0.0f; ///< m/s, of the strongest source that reaches the field. Only bent stems feel it.
	float turns = 0.0f; ///< 0 to 1: PartAir::turns().
	float drops = 0.0f; ///< 0 to 1: drop_chance().
};

/// Bend of a part relative to its stem: the stereographic image of its tip's turn about its pivot, at most
/// MAX_PART_BEND. It is a function of the stem's motion, without a state of its own:
///
/// - the wind that bends the stem bends the part the same way, most on the windward side and least on the lee side,
/// - it lags behind the stem, by a time that grows with its damping and falls with its frequency,
/// - it flutters in air that is faster than its onset, which grows with its frequency, at about its frequency and its
///   own phase; soon with an amplitude that hardly grows, most on the lee side, and less with more damping (Tadrist et
///   al. 2018),
/// - drops of rain push it down; it swings back at its frequency within a second,
/// - stiff parts (of high frequency) move less, and no part folds far towards its stem or into the ground.
///
/// So parts of a stem at rest in calm air are still, and parts of a stem that a body holds in calm air, too. The result
/// is bounded and finite for all inputs. undergrowth_part_bend() in
/// addons/undergrowth/shaders/undergrowth_swing.gdshaderinc mirrors it for fields; change both together.
glm::vec2 part_bend(const PartMotion &part, const StemMotion &stem);

/// The same for a part on swinging parts, as a twig on a branch: `count` carriers, the outermost swing first. Each
/// order of branches has its own law on the motion of those that carry it. Besides the above:
///
/// - the part is an oscillator of its frequency and damping, driven by the flutter of its carriers, which turns its
///   base: in the steady state it overshoots a slow carrier, lags a quarter of a turn behind one of its own frequency,
///   and stays in place on a fast one,
/// - it lags behind the rate of the stem and that of its carriers.
///
/// The closed form of the steady state needs no state. The shift of the base is left out.
glm::vec2 part_bend(const PartMotion &part, const StemMotion &stem, const CarrierSwing *carriers, int count);

/// Relative motion of an oscillator on a base that swings harmonically with the amplitude 1: the part in phase with the
/// base (x) and the part that lags by a quarter of a turn (y). `ratio`: frequency of the base over its own.
glm::vec2 response_to_base(float ratio, float damping_ratio);

/// About 44°: of a tip's turn as seen from the pivot. The tip itself points twice as far.
inline constexpr float MAX_PART_BEND = 0.4f;

/// Turns `v` by a bend, as undergrowth_turned() in the shaders.
glm::vec3 turned(const glm::vec3 &v, const glm::vec2 &bend);

/// Position of a point of a part with the bend `bend`, relative to the pivot; `way` is its position at rest. `weight`:
/// its bend weight, 0 at the attachment and 1 at the tip. A straight blade becomes an arc of a circle of the same
/// length.
glm::vec3 bent_way(const glm::vec3 &way, const glm::vec2 &bend, float weight);

/// Bend at a point of a part from the bend of its tip: the angle is `weight` times the tip's. Within 1e-4.
glm::vec2 bend_at(const glm::vec2 &tip, float weight);

/// Ratio of chord to arc for a chord that is turned by this bend.
float arc_share(const glm::vec2 &bend);

/// Rotation, scale and translation of a bone.
struct PartPose {
	glm::vec4 turn = { 0.0f, 0.0f, 0.0f, 1.0f }; ///< Unit quaternion, w last.
	float size = 1.0f;
	glm::vec3 shift = { 0.0f, 0.0f, 0.0f }; ///< m: new position of the plant's root.
};

/// Pose of a bone, in the plant's axes. Linear blend skinning from the stem to it, and on to the bone of the outer
/// half, shows what shaders show, to the first order of the bend.
PartPose pose_of(const PartBone &bone, const StemMotion &stem);

/// A bent stem, in the plant's axes.
struct PosedStem {
	const StemConstants &constants;
	float height; ///< m, of the plant.
	glm::vec2 rest; ///< The bend in calm air.
	glm::vec2 amplitudes[MAX_STEM_MODES] = {}; ///< In the frame of the rest.

	PosedStem(const StemConstants &stem, float plant_height, const StemMotion &motion);
	/// New position of a point `place` (m) that is attached to the stem at the offset x: as undergrowth_bend_stem() in
	/// the shaders.
	glm::vec3 place_of(const glm::vec3 &place, float x) const;
	/// Unit quaternion, w last.
	glm::vec4 turn_at(float x) const;

private:
	glm::vec2 lean_at(float x) const;
};

/// Pose of a bone on such a stem, as pose_of() above.
PartPose pose_of(const PartBone &bone, const StemMotion &motion, const PosedStem &stem);

} // namespace undergrowth

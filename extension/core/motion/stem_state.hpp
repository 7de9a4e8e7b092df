#pragma once

#include "motion/bend_encoding.hpp"
#include "motion/joint.hpp"
#include "stem/stem_constants.hpp"

#include <glm/vec2.hpp>

namespace undergrowth {

/// A stem's motion: amplitudes of its modes (StemMode) and their rates (1/s), in the frame of its rest direction, that
/// is what the shortest turn from upright to the rest makes of the plant's axes. x and y are along x and z there.
struct StemState {
	glm::vec2 place[MOST_STEM_MODES] = {};
	glm::vec2 rate[MOST_STEM_MODES] = {};
};

/// Bends are stereographic images of directions (motion/bend_encoding.hpp).

/// `bend`, seen from the frame of a rest direction whose bend is `rest`, as it is in the axes around; and back. Both
/// are turns of the sphere, so nothing is approximated.
glm::vec2 out_of_rest(const glm::vec2 &bend, const glm::vec2 &rest);
glm::vec2 into_rest(const glm::vec2 &bend, const glm::vec2 &rest);

/// The bend of a stem's tip that its modes say, t in StemConstants, in the frame of its rest.
glm::vec2 tip_bend(const StemConstants &stem, const StemState &state);

/// Where the tip points and how fast that changes, in the axes around.
TipState tip_state(const StemConstants &stem, const StemState &state, const glm::vec2 &rest);

/// What the second mode adds to the tip's bend beyond its share in a steady wind (first_share()): across the rest
/// direction, in the axes around. Zeros of a stem of one mode.
struct StemSecond {
	glm::vec3 bend = { 0.0f, 0.0f, 0.0f };
	glm::vec3 rate = { 0.0f, 0.0f, 0.0f }; ///< 1/s.
};

/// All that moves of a plant.
struct MotionState {
	TipState tip;
	StemSecond second;
};

StemSecond second_of(const StemConstants &stem, const StemState &state, const glm::vec2 &rest);

/// A stem whose tip points and turns so, as much of it in the second mode as in a steady wind, and `second` besides. A
/// tip beyond what a mode may do (MOST_STEM_AMPLITUDE) comes back to it.
StemState stem_state(
		const StemConstants &stem, const TipState &tip, const glm::vec2 &rest, const StemSecond &second = {});

/// The bend, or its rate, of a tip in each mode, in the frame of the rest, if all keep the shape of a steady wind.
void divide_tip(const StemConstants &stem, const glm::vec2 &tip, glm::vec2 *modes);

/// The nearest usable state: no mode farther or faster than it may, nothing but finite numbers.
StemState safe_stem(const StemConstants &stem, const StemState &state);

/// What a page keeps of a stem for the graphics card (motion/bend_encoding.hpp): the bend of the tip that the first
/// mode gives, in the axes around, so that all who know of one joint read it as that joint's; and what the second one
/// adds to the tip's bend, in the frame of the rest.
struct StemBends {
	Bend first;
	Bend second;
};
StemBends bends_of(const StemConstants &stem, const StemState &state, const glm::vec2 &rest);

/// Bends of one mode (`second` is 0) or two, as `stem` shows them: whose modes are both have those that a steady wind
/// gives the same tip, whose is one has the tip.
StemBends bends_in_modes(const StemConstants &stem, const StemBends &bends, const glm::vec2 &rest);

/// What bends of all modes are of the tip's bend: the first one's in the axes around, the second one's in the frame of
/// the rest, as StemBends has them.
struct ModeBends {
	glm::vec2 first = { 0.0f, 0.0f };
	glm::vec2 second = { 0.0f, 0.0f };
};

/// How a stem moves that went from `before` to `now` in `step` seconds.
MotionState motion_between(
		const StemConstants &stem, const ModeBends &before, const ModeBends &now, const glm::vec2 &rest, float step);

/// No mode is faster, over its frequency (rad/s).
inline constexpr float MOST_STEM_RATE = 6.0f;

} // namespace undergrowth

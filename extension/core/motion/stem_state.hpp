#pragma once

#include "motion/bend_encoding.hpp"
#include "motion/joint.hpp"
#include "stem/stem_constants.hpp"

#include <glm/vec2.hpp>

namespace undergrowth {

/// A stem's motion: amplitudes of its modes (StemMode) and their rates (1/s), in the frame of its rest direction:
/// the plant's axes after the shortest turn from upright to the rest. x and y are along x and z there.
struct StemState {
	glm::vec2 place[MAX_STEM_MODES] = {};
	glm::vec2 rate[MAX_STEM_MODES] = {};
};

/// Bends are stereographic images of directions (motion/bend_encoding.hpp).

/// Converts `bend` from the frame of a rest direction (bend `rest`) to the plant's axes, and back. Both are exact
/// rotations of the sphere.
glm::vec2 out_of_rest(const glm::vec2 &bend, const glm::vec2 &rest);
glm::vec2 into_rest(const glm::vec2 &bend, const glm::vec2 &rest);

/// Bend of a stem's tip from its modes, t in StemConstants, in the frame of its rest.
glm::vec2 tip_bend(const StemConstants &stem, const StemState &state);

/// Direction of the tip and its rate, in the plant's axes.
TipState tip_state(const StemConstants &stem, const StemState &state, const glm::vec2 &rest);

/// The second mode's part of the tip's bend beyond its share in a steady wind (first_share()): across the rest
/// direction, in the plant's axes. Zero with one mode.
struct StemSecond {
	glm::vec3 bend = { 0.0f, 0.0f, 0.0f };
	glm::vec3 rate = { 0.0f, 0.0f, 0.0f }; ///< 1/s.
};

/// The whole motion of a plant.
struct MotionState {
	TipState tip;
	StemSecond second;
};

StemSecond second_of(const StemConstants &stem, const StemState &state, const glm::vec2 &rest);

/// Stem state from the motion of its tip, divided between the modes as in a steady wind, plus `second`. Amplitudes are
/// clamped to MAX_STEM_AMPLITUDE.
StemState stem_state(
		const StemConstants &stem, const TipState &tip, const glm::vec2 &rest, const StemSecond &second = {});

/// Divides a tip's bend, or its rate, between the modes with the shape of a steady wind, in the frame of the rest.
void divide_tip(const StemConstants &stem, const glm::vec2 &tip, glm::vec2 *modes);

/// The nearest valid state: amplitudes and rates within their limits, all numbers finite.
StemState safe_stem(const StemConstants &stem, const StemState &state);

/// Bends of a stem for the graphics card (motion/bend_encoding.hpp): the first mode's part of the tip's bend in the
/// plant's axes, which readers of one joint use as that joint's, and the second mode's part in the frame of the rest.
struct StemBends {
	Bend first;
	Bend second;
};
StemBends bends_of(const StemConstants &stem, const StemState &state, const glm::vec2 &rest);

/// Converts bends of one mode (`second` is 0) or two to the number of modes of `stem`. Two modes get the division of a
/// steady wind for the same tip; one mode gets the tip.
StemBends bends_in_modes(const StemConstants &stem, const StemBends &bends, const glm::vec2 &rest);

/// StemBends as floats: the first mode's in the plant's axes, the second mode's in the frame of the rest.
struct ModeBends {
	glm::vec2 first = { 0.0f, 0.0f };
	glm::vec2 second = { 0.0f, 0.0f };
};

/// Motion of a stem that changed from `before` to `now` in `step` seconds.
MotionState motion_between(
		const StemConstants &stem, const ModeBends &before, const ModeBends &now, const glm::vec2 &rest, float step);

/// Maximum rate of a mode, relative to its frequency (rad/s).
inline constexpr float MAX_STEM_RATE = 6.0f;

} // namespace undergrowth

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

/// A stem whose tip points and turns so: all of it in the first mode, the second one is still. A tip beyond what a mode
/// may do (MOST_STEM_AMPLITUDE) comes back to it.
StemState stem_state(const StemConstants &stem, const TipState &tip, const glm::vec2 &rest);

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

/// No mode is faster, over its frequency (rad/s).
inline constexpr float MOST_STEM_RATE = 6.0f;

} // namespace undergrowth

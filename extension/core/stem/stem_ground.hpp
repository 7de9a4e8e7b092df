#pragma once

#include "stem/stem_constants.hpp"

namespace undergrowth {

/// Height at which the ground stops a tip, relative to the stem's length.
inline constexpr float GROUND_HEIGHT = 0.02f;

/// StemMode::chord of both modes, 0 for one that is not there. Small bends of the way to the tip are two thirds of
/// that, so stems that lean stop a little above the ground.
struct StemChords {
	float first = 0.0f;
	float second = 0.0f;
};
/// Uses the shape of large bends in `stem`: that of newtons, or of in_air().
StemChords chords_of(const StemConstants &stem);

} // namespace undergrowth

#pragma once

#include "stem/stem_constants.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace undergrowth {

/// The centres of places `first` to `last` of `count` along a stem, evenly spaced from 1 above the root to the tip: to
/// the bit what stem_place() finds for each, at a fraction of the cost.
void stem_points(
		const StemConstants &stem, const glm::vec2 *amplitudes, int count, int first, int last, glm::vec3 *centres);

} // namespace undergrowth

#pragma once

#include "stem/stem_beam.hpp"

namespace undergrowth {

/// Fills in how frequencies and slopes of a stem go by height, all else of it being the same: through what the linear
/// beam says at 0.7 and 1.3 times its length, or less where it would fall. For beams whose stiffness is given.
void grade_by_height(const StemBeam &beam, StemConstants &constants);

} // namespace undergrowth

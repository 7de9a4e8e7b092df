#pragma once

#include "stem/stem_beam.hpp"

namespace undergrowth {

/// Fills in the grades of frequencies and slopes by height, with all other parameters equal. They interpolate the
/// linear beam at 0.7 and 1.3 times its length, or closer where it would fall. `beam` has the stiffness.
void grade_by_height(const StemBeam &beam, StemConstants &constants);

} // namespace undergrowth

#pragma once

#include "stem/stem_constants.hpp"

#include <array>

namespace undergrowth {

constexpr int STEM_SAMPLES = 65;
/// Values at x = i/64.
using StemSamples = std::array<double, STEM_SAMPLES>;
/// Coefficients of x, x², … of a shape that is 0 at the root.
using StemTerms = std::array<double, STEM_SHAPE_TERMS>;

/// The terms nearest to the samples (least squares).
StemTerms fit_shape(const StemSamples &samples);

/// The constants for a wind in m/s: shape[j] has the large bends of air.
StemConstants in_air(const StemConstants &stem);

/// The same stem with one mode that has the shape of a steady wind force. Under that wind both look the same. The
/// amplitude is the tip's bend. A stem with one mode is returned unchanged.
StemConstants in_one_mode(const StemConstants &stem);
/// Fraction of the tip's bend that belongs to the first mode in that shape; 1 for a single mode.
float first_share(const StemConstants &stem);

} // namespace undergrowth

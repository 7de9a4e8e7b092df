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

/// The constants of a stem that stands in air of so many m/s: shape[j] has the large bends of that wind.
StemConstants in_air(const StemConstants &stem);

} // namespace undergrowth

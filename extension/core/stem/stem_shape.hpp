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

/// The same stem with one mode, whose shape is that of a steady wind in newtons: at that wind, and at all bends that
/// keep its shape, all that is seen of both is the same. Its amplitude is the tip's bend. One of one mode stays.
StemConstants in_one_mode(const StemConstants &stem);
/// How much of the tip's bend the first mode has at such a bend; 1 where it is alone.
float first_share(const StemConstants &stem);

} // namespace undergrowth

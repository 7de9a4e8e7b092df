#pragma once

#include "stem/stem_chain.hpp"
#include "stem/stem_shape.hpp"

namespace undergrowth {

/// Corrections of large steady bends to the static shape ψ of the linear beam (1 at the tip); t is the tip's bend by
/// the wind's law: u(x) = t·ψ + t³·x3 + t⁵·x5. Least squares of directions beside a chain under winds that give a
/// linear tip slopes of 0.5 to 12, in air to 30.
struct LargeBends {
	StemSamples x3;
	StemSamples x5;
};

/// For a wind force; `newtons` give a linear slope of 1. Its law: tan θ = slope.
LargeBends large_bends_of_newtons(const StemChain &chain, const StemSamples &shape, double newtons);
/// For air; `speed_squared` (m²/s²) gives a linear slope of 1. Its law: sin θ/cos²θ = slope.
LargeBends large_bends_of_air(const StemChain &chain, const StemSamples &shape, double speed_squared);

} // namespace undergrowth

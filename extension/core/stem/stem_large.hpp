#pragma once

#include "stem/stem_chain.hpp"
#include "stem/stem_shape.hpp"

namespace undergrowth {

/// What large steady bends add to the static shape ψ of the linear beam (1 at the tip), t being the tip's bend as the
/// wind's law says it: u(x) = t·ψ + t³·x3 + t⁵·x5. Least squares of directions beside a chain under winds that give a
/// linear tip slopes of 0.5 to 12, in air to 30.
struct LargeBends {
	StemSamples x3;
	StemSamples x5;
};

/// In a wind in newtons, of which `newtons` give a linear slope of 1. Its law: tan θ = slope.
LargeBends large_bends_of_newtons(const StemChain &chain, const StemSamples &shape, double newtons);
/// In air, whose speed gives a linear slope of 1 at this square (m²/s²). Its law: sin θ/cos²θ = slope.
LargeBends large_bends_of_air(const StemChain &chain, const StemSamples &shape, double speed_squared);

} // namespace undergrowth

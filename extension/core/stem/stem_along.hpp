#pragma once

#include "stem/stem_chain.hpp"
#include "stem/stem_constants.hpp"

namespace undergrowth {

/// StemConstants::dead_along: with it the tip of a stem that leans 35° against the wind is nearest to that of a chain,
/// at linear slopes of the tip of 1 and 4. Needs the shapes and slopes of `stem`.
StemAlong along_of_newtons(const StemChain &chain, const StemConstants &stem);
/// StemConstants::air_along, in the same way.
StemAlong along_of_air(const StemChain &chain, const StemConstants &stem);
/// StemConstants::nod: with it the tip of a stem that leans 20° or 60° is nearest at rest to that of a chain that is
/// straight without its weight. Between them it is within 1 % of the length.
StemNod nod_of(const StemChain &chain, const StemConstants &stem);

} // namespace undergrowth

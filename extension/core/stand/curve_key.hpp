#pragma once

#include <cstdint>

namespace undergrowth {

/// Place along Hilbert's curve (Hilbert 1891), which goes from each square of a grid to one beside it.
uint64_t curve_key(int column, int row);

} // namespace undergrowth

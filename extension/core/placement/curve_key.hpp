#pragma once

#include <cstdint>

namespace undergrowth {

/// Index of a grid cell along Hilbert's curve (Hilbert 1891), which connects neighbouring cells.
uint64_t curve_key(int column, int row);

} // namespace undergrowth

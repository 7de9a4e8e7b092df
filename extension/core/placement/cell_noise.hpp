#pragma once

#include <cstdint>

namespace undergrowth {

/// Random bits of a cell of the plane. Equal to undergrowth_cell_hash() of the shaders.
uint32_t noise_bits(int column, int row);

/// Smooth noise from -1 to 1 with one cell per unit, the same on every platform.
double smooth_noise(double x, double z);

} // namespace undergrowth

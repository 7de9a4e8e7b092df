#pragma once

#include <vector>

namespace undergrowth {

/// Complex numbers on a grid, row by row: real and imaginary parts apart.
struct ComplexGrid {
	ComplexGrid(int columns, int rows);

	int width, height; ///< Powers of two.
	std::vector<double> real, imaginary;
};

/// Replaces amplitudes by what they are at each place: the sum over all waves (i, j) of their amplitude times
/// exp(2πi·(i·x/width + j·y/height)). Radix 2, with the same bits on every platform.
void sum_waves(ComplexGrid &grid);

} // namespace undergrowth

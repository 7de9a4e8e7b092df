#include "wind/fourier.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"

#include <cstddef>
#include <utility>

namespace undergrowth {

namespace {

/// cos and sin of 2π·k/count for k below count/2.
struct Twiddles {
	explicit Twiddles(int count) {
		for (int k = 0; k < count / 2; k++) {
			const double angle = 2.0 * PI * k / count;
			cosines.push_back(portable_cos(angle));
			sines.push_back(portable_sin(angle));
		}
	}

	std::vector<double> cosines, sines;
};

/// A line of a grid: numbers `stride` apart. `lanes` neighbours are summed together.
struct Lines {
	double *real;
	double *imaginary;
	std::size_t stride;
	std::size_t lanes;

	double *real_at(int index) const { return real + static_cast<std::size_t>(index) * stride; }
	double *imaginary_at(int index) const { return imaginary + static_cast<std::size_t>(index) * stride; }
};

void reverse_bits(const Lines &lines, int count) {
	for (int i = 1, j = 0; i < count; i++) {
		int bit = count / 2;
		for (; (j & bit) != 0; bit /= 2) {
			j ^= bit;
		}
		j ^= bit;
		for (std::size_t lane = 0; i < j && lane < lines.lanes; lane++) {
			std::swap(lines.real_at(i)[lane], lines.real_at(j)[lane]);
			std::swap(lines.imaginary_at(i)[lane], lines.imaginary_at(j)[lane]);
		}
	}
}

void butterfly(const Lines &lines, int low, int high, double cosine, double sine) {
	double *low_real = lines.real_at(low);
	double *low_imaginary = lines.imaginary_at(low);
	double *high_real = lines.real_at(high);
	double *high_imaginary = lines.imaginary_at(high);
	for (std::size_t lane = 0; lane < lines.lanes; lane++) {
		const double real = high_real[lane] * cosine - high_imaginary[lane] * sine;
		const double imaginary = high_real[lane] * sine + high_imaginary[lane] * cosine;
		high_real[lane] = low_real[lane] - real;
		high_imaginary[lane] = low_imaginary[lane] - imaginary;
		low_real[lane] += real;
		low_imaginary[lane] += imaginary;
	}
}

void sum_lines(const Lines &lines, int count, const Twiddles &twiddles) {
	reverse_bits(lines, count);
	for (int half = 1; half < count; half *= 2) {
		const int turn = count / (2 * half);
		for (int first = 0; first < count; first += 2 * half) {
			for (int k = 0; k < half; k++) {
				const auto angle = static_cast<std::size_t>(k * turn);
				butterfly(lines, first + k, first + k + half, twiddles.cosines[angle], twiddles.sines[angle]);
			}
		}
	}
}

} // namespace

ComplexGrid::ComplexGrid(int columns, int rows) :
		width(columns),
		height(rows),
		real(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)),
		imaginary(real.size()) {}

void sum_waves(ComplexGrid &grid) {
	constexpr std::size_t LANES = 8; // Columns that are neighbours share cache lines.
	const auto width = static_cast<std::size_t>(grid.width);
	const Twiddles along(grid.width);
	for (std::size_t first = 0; first < grid.real.size(); first += width) {
		sum_lines({ &grid.real[first], &grid.imaginary[first], 1, 1 }, grid.width, along);
	}
	const Twiddles across(grid.height);
	for (std::size_t first = 0; first < width; first += LANES) {
		const std::size_t lanes = width - first < LANES ? width - first : LANES;
		sum_lines({ &grid.real[first], &grid.imaginary[first], width, lanes }, grid.height, across);
	}
}

} // namespace undergrowth

#include "wind/fourier.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"

#include <algorithm>
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

constexpr std::size_t LANES = 8; // Number of lines that are summed together: neighbours in memory.

/// Lines side by side: number `index` of the first line is at index·stride, and the other lines follow it.
struct Lines {
	double *real;
	double *imaginary;
	std::size_t stride;

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
		for (std::size_t lane = 0; i < j && lane < LANES; lane++) {
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
	for (std::size_t lane = 0; lane < LANES; lane++) {
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

/// Copies lines of a grid side by side: `apart` numbers lie between lines, `step` between a line's numbers.
class SideBySide {
public:
	explicit SideBySide(int count) :
			size(static_cast<std::size_t>(count)), real(size * LANES), imaginary(size * LANES), twiddles(count) {}

	void sum(double *grid_real, double *grid_imaginary, std::size_t lines, std::size_t apart, std::size_t step) {
		const auto copy = [&](const auto &one) {
			for (std::size_t i = 0; i < size; i++) {
				for (std::size_t lane = 0; lane < lines; lane++) {
					one(i * LANES + lane, i * step + lane * apart);
				}
			}
		};
		copy([&](std::size_t here, std::size_t there) {
			real[here] = grid_real[there];
			imaginary[here] = grid_imaginary[there];
		});
		sum_lines({ real.data(), imaginary.data(), LANES }, static_cast<int>(size), twiddles);
		copy([&](std::size_t here, std::size_t there) {
			grid_real[there] = real[here];
			grid_imaginary[there] = imaginary[here];
		});
	}

private:
	std::size_t size;
	std::vector<double> real, imaginary;
	Twiddles twiddles;
};

} // namespace

ComplexGrid::ComplexGrid(int columns, int rows) :
		width(columns),
		height(rows),
		real(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)),
		imaginary(real.size()) {}

void sum_waves(ComplexGrid &grid) {
	const auto width = static_cast<std::size_t>(grid.width);
	const auto height = static_cast<std::size_t>(grid.height);
	SideBySide rows(grid.width);
	for (std::size_t first = 0; first < height; first += LANES) {
		double *real = &grid.real[first * width];
		rows.sum(real, &grid.imaginary[first * width], std::min(LANES, height - first), width, 1);
	}
	SideBySide columns(grid.height);
	for (std::size_t first = 0; first < width; first += LANES) {
		columns.sum(&grid.real[first], &grid.imaginary[first], std::min(LANES, width - first), 1, width);
	}
}

} // namespace undergrowth

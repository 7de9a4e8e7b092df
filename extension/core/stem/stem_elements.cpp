#include "stem/stem_elements.hpp"

#include "conventions.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr int ELEMENTS = StemCurve::ELEMENTS;
constexpr int SIZE = StemCurve::SIZE;
constexpr double H = 1.0 / ELEMENTS;
constexpr double GAUSS_PLACE[4] = { 0.069431844202973712, 0.33000947820757187, 0.66999052179242813,
	0.93056815579702629 };
constexpr double GAUSS_WEIGHT[4] = { 0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
	0.17392742256872693 };
constexpr double MIN_PIVOT = 1e-11; // Of the entry before.
constexpr int ITERATIONS = 40; // Each reduces the second mode's share by a factor of at least 3.

/// For the four values of an element at ξ from 0 to 1 within it: the shapes and their first two derivatives by x.
struct Shapes {
	double value[4];
	double slope[4];
	double curvature[4];

	explicit Shapes(double t) :
			value{ 1.0 - t * t * (3.0 - 2.0 * t), H * t * (1.0 - t) * (1.0 - t), t * t * (3.0 - 2.0 * t),
				H * t * t * (t - 1.0) },
			slope{ -6.0 * t * (1.0 - t) / H, 1.0 - t * (4.0 - 3.0 * t), 6.0 * t * (1.0 - t) / H, t * (3.0 * t - 2.0) },
			curvature{ (12.0 * t - 6.0) / (H * H), (6.0 * t - 4.0) / H, (6.0 - 12.0 * t) / (H * H),
				(6.0 * t - 2.0) / H } {}
};

/// Index of an element's first value; those of the root are negative.
int first_of(int element) {
	return 2 * element - 2;
}

void add_product(StemMatrix &matrix, int element, const double *shape, double factor) {
	for (int i = 0; i < 4; i++) {
		for (int j = 0; j < 4; j++) {
			matrix.add(first_of(element) + i, first_of(element) + j, factor * shape[i] * shape[j]);
		}
	}
}

int element_at(double x) {
	return std::clamp(static_cast<int>(x * ELEMENTS), 0, ELEMENTS - 1);
}

double sum_of(const StemCurve &curve, int element, const double *shape) {
	double sum = 0.0;
	for (int i = 0; i < 4; i++) {
		const int row = first_of(element) + i;
		sum += row >= 0 ? curve[row] * shape[i] : 0.0;
	}
	return sum;
}

/// The weight of a mass at `place` presses on everything below.
void add_pressure(StemMatrix &gravity, double place, double force) {
	for (int e = 0; e < ELEMENTS; e++) {
		const double share = std::clamp(place * ELEMENTS - e, 0.0, 1.0);
		for (int g = 0; g < 4; g++) {
			add_product(gravity, e, Shapes(share * GAUSS_PLACE[g]).slope, force * share * H * GAUSS_WEIGHT[g]);
		}
	}
}

} // namespace

void StemCurve::add(const StemCurve &other, double factor) {
	for (int i = 0; i < SIZE; i++) {
		values[i] += factor * other[i];
	}
}

void StemCurve::scale(double factor) {
	for (double &value : values) {
		value *= factor;
	}
}

double StemCurve::dot(const StemCurve &other) const {
	double sum = 0.0;
	for (int i = 0; i < SIZE; i++) {
		sum += values[i] * other[i];
	}
	return sum;
}

double StemCurve::deflection(double x) const {
	const int e = element_at(x);
	return sum_of(*this, e, Shapes(x * ELEMENTS - e).value);
}

double StemCurve::slope(double x) const {
	const int e = element_at(x);
	return sum_of(*this, e, Shapes(x * ELEMENTS - e).slope);
}

void StemMatrix::add(int row, int column, double value) {
	if (row >= 0 && column >= 0) {
		rows[row][column - row + BAND] += value;
	}
}

StemMatrix StemMatrix::mixed(double factor, const StemMatrix &other, double other_factor) const {
	StemMatrix result;
	for (int i = 0; i < SIZE; i++) {
		for (int j = 0; j <= 2 * BAND; j++) {
			result.rows[i][j] = factor * rows[i][j] + other_factor * other.rows[i][j];
		}
	}
	return result;
}

StemCurve StemMatrix::times(const StemCurve &curve) const {
	StemCurve result;
	for (int i = 0; i < SIZE; i++) {
		for (int j = std::max(i - BAND, 0); j <= std::min(i + BAND, SIZE - 1); j++) {
			result[i] += at(i, j) * curve[j];
		}
	}
	return result;
}

StemFactors::StemFactors(const StemMatrix &matrix) {
	constexpr int BAND = StemMatrix::BAND;
	for (int i = 0; i < SIZE; i++) {
		for (int j = std::max(i - BAND, 0); j <= i; j++) {
			double sum = matrix.at(i, j);
			for (int k = std::max(i - BAND, 0); k < j; k++) {
				sum -= lower[i][k - i + BAND] * lower[j][k - j + BAND];
			}
			if (j < i) {
				lower[i][j - i + BAND] = sum / lower[j][BAND];
			} else if (sum > MIN_PIVOT * matrix.at(i, i)) {
				lower[i][BAND] = std::sqrt(sum);
			} else {
				sound = false;
				return;
			}
		}
	}
}

StemCurve StemFactors::solve(const StemCurve &right) const {
	constexpr int BAND = StemMatrix::BAND;
	StemCurve result = right;
	for (int i = 0; i < SIZE; i++) {
		for (int j = std::max(i - BAND, 0); j < i; j++) {
			result[i] -= lower[i][j - i + BAND] * result[j];
		}
		result[i] /= lower[i][BAND];
	}
	for (int i = SIZE - 1; i >= 0; i--) {
		for (int j = i + 1; j <= std::min(i + BAND, SIZE - 1); j++) {
			result[i] -= lower[j][i - j + BAND] * result[j];
		}
		result[i] /= lower[i][BAND];
	}
	return result;
}

StemElements::StemElements(const StemLine &line) {
	const double length = line.length;
	const double pull = STANDARD_GRAVITY / length;
	for (int e = 0; e < ELEMENTS; e++) {
		for (int g = 0; g < 4; g++) {
			const Shapes shapes(GAUSS_PLACE[g]);
			const double x = (e + GAUSS_PLACE[g]) * H;
			const double weight = H * GAUSS_WEIGHT[g];
			add_product(stiffness, e, shapes.curvature, weight * line.bending(x) / (length * length * length));
			add_product(mass, e, shapes.value, weight * line.mass.at(x));
			add_product(gravity, e, shapes.slope, weight * pull * line.mass.beyond(x));
		}
	}
	for (const StemSpread::Point &point : line.mass.points) {
		const int e = element_at(point.place);
		add_product(mass, e, Shapes(point.place * ELEMENTS - e).value, point.amount);
		add_pressure(gravity, point.place, pull * point.amount);
	}
	const double arm = line.head_centre / length;
	const double tip[2] = { 1.0, arm };
	for (int i = 0; i < 2; i++) {
		for (int j = 0; j < 2; j++) {
			mass.add(SIZE - 2 + i, SIZE - 2 + j, line.head_mass * tip[i] * tip[j]);
		}
	}
	mass.add(SIZE - 1, SIZE - 1, line.head_inertia / (length * length));
	add_pressure(gravity, 1.0, pull * line.head_mass);
	gravity.add(SIZE - 1, SIZE - 1, pull * line.head_mass * arm);
}

StemCurve load_of(const StemLine &line, const StemSpread &spread, double head) {
	StemCurve load;
	const auto add = [&load](double x, double amount) {
		const int e = element_at(x);
		const Shapes shapes(x * ELEMENTS - e);
		for (int i = 0; i < 4; i++) {
			if (first_of(e) + i >= 0) {
				load[first_of(e) + i] += amount * shapes.value[i];
			}
		}
	};
	for (int e = 0; e < ELEMENTS; e++) {
		for (int g = 0; g < 4; g++) {
			const double x = (e + GAUSS_PLACE[g]) * H;
			add(x, H * GAUSS_WEIGHT[g] * spread.at(x));
		}
	}
	for (const StemSpread::Point &point : spread.points) {
		add(point.place, point.amount);
	}
	load[SIZE - 2] += head;
	load[SIZE - 1] += head * line.head_centre / line.length;
	return load;
}

// Inverse iteration from a curve that no mode is orthogonal to: the deflections x² or x³.
StemEigen smallest_eigen(const StemFactors &left, const StemMatrix &right, const StemCurve *before) {
	StemCurve curve;
	for (int i = 0; i < ELEMENTS; i++) {
		const double x = (i + 1) * H;
		curve[2 * i] = before == nullptr ? x * x : x * x * x;
		curve[2 * i + 1] = before == nullptr ? 2.0 * x : 3.0 * x * x;
	}
	const StemCurve weights = before != nullptr ? right.times(*before) : StemCurve();
	double value = 0.0;
	for (int i = 0; i < ITERATIONS; i++) {
		if (before != nullptr) {
			curve.add(*before, -curve.dot(weights));
		}
		curve.scale(1.0 / std::sqrt(curve.dot(right.times(curve))));
		StemCurve next = left.solve(right.times(curve));
		value = 1.0 / next.dot(right.times(curve));
		curve = next;
	}
	if (before != nullptr) {
		curve.add(*before, -curve.dot(weights));
	}
	curve.scale(1.0 / std::sqrt(curve.dot(right.times(curve))));
	return { value, curve };
}

} // namespace undergrowth

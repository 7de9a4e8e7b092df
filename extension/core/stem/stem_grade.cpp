#include "stem/stem_grade.hpp"

#include "stem/stem_elements.hpp"

#include <cmath>

namespace undergrowth {

namespace {

constexpr double LOW = 0.7; // Of the height.
constexpr double HIGH[] = { 1.3, 1.15, 1.05 };
constexpr double LOW_BETWEEN = 0.85; // If the max height is limited.

/// Results of the linear beam of a stem.
struct Linear {
	bool is_stable = false;
	double periods[MAX_STEM_MODES] = {}; ///< s/rad.
	double dead_slope = 0.0; ///< 1/N.
	double air_slope = 0.0; ///< s²/m².
};

Linear linear_of(const StemBeam &beam, double ratio) {
	StemBeam other = beam;
	other.length = static_cast<float>(ratio * static_cast<double>(beam.length));
	const StemLine line(other);
	const StemElements elements(line);
	const auto modulus = static_cast<double>(beam.youngs_modulus);
	const StemFactors factors(elements.stiffness.mixed(modulus, elements.gravity, -1.0));
	Linear linear;
	linear.is_stable = factors.is_sound();
	if (linear.is_stable) {
		const StemEigen first = smallest_eigen(factors, elements.mass);
		const StemEigen second = smallest_eigen(factors, elements.mass, &first.curve);
		linear.periods[0] = 1.0 / std::sqrt(first.value);
		linear.periods[1] = 1.0 / std::sqrt(second.value);
		linear.dead_slope = factors.solve(load_of(line, line.dead, line.head_dead)).slope(1.0) / line.length;
		linear.air_slope = factors.solve(load_of(line, line.air, line.head_air)).slope(1.0) / line.length;
	}
	return linear;
}

/// Parabola through 1 and the values at two more heights.
class Parabola {
public:
	Parabola(double one, double other) : a(one - 1.0), b(other - 1.0) {}

	StemGrade through(double middle, double at_one, double at_other) const {
		const double first = (at_one / middle - 1.0) / a;
		const double second = (at_other / middle - 1.0) / b;
		const double curve = (second - first) / (b - a);
		return { static_cast<float>(first - curve * a), static_cast<float>(curve) };
	}

private:
	double a, b;
};

} // namespace

void grade_by_height(const StemBeam &beam, StemConstants &constants) {
	const Linear own = linear_of(beam, 1.0);
	const Linear low = linear_of(beam, LOW);
	double ratio = LOW_BETWEEN;
	Linear other;
	for (const double high : HIGH) {
		if (!other.is_stable) {
			ratio = high;
			other = linear_of(beam, high);
		}
	}
	if (!other.is_stable) {
		ratio = LOW_BETWEEN;
		other = linear_of(beam, ratio);
	}
	const Parabola parabola(LOW, ratio);
	for (int k = 0; k < constants.modes; k++) {
		constants.mode[k].period = parabola.through(own.periods[k], low.periods[k], other.periods[k]);
	}
	constants.dead_grade = parabola.through(own.dead_slope, low.dead_slope, other.dead_slope);
	constants.air_grade = parabola.through(own.air_slope, low.air_slope, other.air_slope);
}

} // namespace undergrowth

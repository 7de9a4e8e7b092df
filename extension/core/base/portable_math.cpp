#include "base/portable_math.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

// Argument reductions and coefficients are those of fdlibm (Sun Microsystems 1993: e_rem_pio2.c, k_sin.c, k_cos.c,
// e_exp.c). floor, fabs, fmod, frexp and ldexp are exact by definition, so all platforms agree.

namespace undergrowth {

namespace {

constexpr double TWO_OVER_PI = 6.36619772367581382433e-01;
// π/2 in three parts. The first two have 33 bits, so that their products with a count of quarter turns below 2^20 are
// exact.
constexpr double HALF_PI_HIGH = 1.57079632673412561417e+00;
constexpr double HALF_PI_MIDDLE = 6.07710050630396597660e-11;
constexpr double HALF_PI_LOW = 2.02226624879595063154e-21;
constexpr double TWO_PI = 6.28318530717958647693e+00;
constexpr double LARGEST_EXACT_ANGLE = 1.6e6;

constexpr double ONE_OVER_LN2 = 1.44269504088896338700e+00;
constexpr double LN2_HIGH = 6.93147180369123816490e-01;
constexpr double LN2_LOW = 1.90821492927058770002e-10;
constexpr double LARGEST_EXPONENT = 7.09782712893383973096e+02;
constexpr double SMALLEST_EXPONENT = -7.45133219101941108420e+02;

/// angle = quadrant·π/2 + rest, |rest| <= π/4 (slightly more at the border).
struct Reduced {
	int quadrant; ///< 0 to 3.
	double rest;
};

Reduced reduce_angle(double angle) {
	// Beyond the exact range an angle is still reduced, so the results stay within [-1, 1].
	const double within = std::fabs(angle) <= LARGEST_EXACT_ANGLE ? angle : std::fmod(angle, TWO_PI);
	const double turns = within * TWO_OVER_PI + 0.5;
	auto whole = static_cast<int64_t>(turns); // std::floor() is a function call for old processors.
	whole -= static_cast<int64_t>(static_cast<double>(whole) > turns);
	const auto count = static_cast<double>(whole);
	const double high = within - count * HALF_PI_HIGH;
	const double middle = count * HALF_PI_MIDDLE;
	const double rest = high - middle;
	const double lost = (high - rest) - middle;
	return { static_cast<int>(whole & 3), rest + (lost - count * HALF_PI_LOW) };
}

double sin_kernel(double x) {
	const double z = x * x;
	const double r = 8.33333333332248946124e-03 +
			z *
					(-1.98412698298579493134e-04 +
							z *
									(2.75573137070700676789e-06 +
											z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
	return x + x * z * (-1.66666666666666324348e-01 + z * r);
}

double cos_kernel(double x) {
	const double z = x * x;
	const double r = 4.16666666666666019037e-02 +
			z *
					(-1.38888888888741095749e-03 +
							z *
									(2.48015872894767294178e-05 +
											z *
													(-2.75573143513906633035e-07 +
															z *
																	(2.08757232129817482790e-09 +
																			z * -1.13596475577881948265e-11))));
	return 1.0 - (0.5 * z - z * z * r);
}

/// Sine of `quadrant` quarter turns plus `rest`.
double sin_of(int quadrant, double rest) {
	const double size = (quadrant & 1) != 0 ? cos_kernel(rest) : sin_kernel(rest);
	return (quadrant & 2) != 0 ? -size : size;
}

} // namespace

double portable_sin(double angle) {
	if (!std::isfinite(angle)) {
		return std::numeric_limits<double>::quiet_NaN();
	}
	const Reduced reduced = reduce_angle(angle);
	return sin_of(reduced.quadrant, reduced.rest);
}

double portable_cos(double angle) {
	if (!std::isfinite(angle)) {
		return std::numeric_limits<double>::quiet_NaN();
	}
	const Reduced reduced = reduce_angle(angle);
	return sin_of(reduced.quadrant + 1, reduced.rest);
}

SineAndCosine portable_sine_and_cosine(double angle) {
	if (!std::isfinite(angle)) {
		return { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN() };
	}
	// The quadrant is unpredictable, so a table is faster than a branch.
	constexpr double SIGNS[] = { 1.0, 1.0, -1.0, -1.0, 1.0 };
	const Reduced reduced = reduce_angle(angle);
	const double sizes[] = { sin_kernel(reduced.rest), cos_kernel(reduced.rest) };
	const int quadrant = reduced.quadrant;
	return { SIGNS[quadrant] * sizes[quadrant & 1], SIGNS[quadrant + 1] * sizes[(quadrant + 1) & 1] };
}

double portable_tan(double angle) {
	const SineAndCosine both = portable_sine_and_cosine(angle);
	return both.sine / both.cosine;
}

double portable_exp(double exponent) {
	if (std::isnan(exponent)) {
		return exponent;
	}
	if (exponent > LARGEST_EXPONENT) {
		return std::numeric_limits<double>::max();
	}
	if (exponent < SMALLEST_EXPONENT) {
		return 0.0;
	}
	const double count = std::floor(exponent * ONE_OVER_LN2 + 0.5);
	const double high = exponent - count * LN2_HIGH;
	const double low = count * LN2_LOW;
	const double x = high - low;
	const double z = x * x;
	const double c = x -
			z *
					(1.66666666666666019037e-01 +
							z *
									(-2.77777777770155933842e-03 +
											z *
													(6.61375632143793436117e-05 +
															z *
																	(-1.65339022054652515390e-06 +
																			z * 4.13813679705723846039e-08))));
	const double scaled = 1.0 - ((low - (x * c) / (2.0 - c)) - high);
	return std::ldexp(scaled, static_cast<int>(count));
}

double portable_log(double value) {
	if (!(value > 0.0) || !std::isfinite(value)) {
		return std::numeric_limits<double>::quiet_NaN();
	}
	// value = m·2^count with m in [√½, √2]; ln m = 2·artanh((m - 1)/(m + 1)). The argument is below 0.172: eleven terms
	// of the series leave an error below 1e-17.
	int count = 0;
	double m = std::frexp(value, &count);
	if (m < 0.70710678118654752440) {
		m *= 2.0;
		count--;
	}
	const double f = (m - 1.0) / (m + 1.0);
	double sum = 0.0;
	for (int i = 21; i >= 1; i -= 2) {
		sum = 1.0 / i + sum * f * f;
	}
	return count * LN2_HIGH + (count * LN2_LOW + 2.0 * f * sum);
}

double portable_pow(double base, double exponent) {
	if (exponent == 0.0 || base == 1.0) {
		return 1.0;
	}
	if (base == 0.0) {
		return exponent > 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
	}
	return portable_exp(exponent * portable_log(base));
}

double portable_atan2(double y, double x) {
	const double length = std::sqrt(x * x + y * y);
	if (!(length > 0.0)) {
		return 0.0;
	}
	// The tangent of half the angle, from -1 to 1 on the right side of the plane. atan(t) = 2·atan(t/(1 + √(1 + t²))),
	// twice more, leaves |t| < 0.2. There eleven terms of the series leave an error below 1e-17.
	double t = y / (length + std::fabs(x));
	for (int i = 0; i < 2; i++) {
		t = t / (1.0 + std::sqrt(1.0 + t * t));
	}
	double sum = 0.0;
	for (int i = 21; i >= 1; i -= 2) {
		sum = ((i / 2) % 2 == 0 ? 1.0 : -1.0) / i + sum * t * t;
	}
	const double angle = 8.0 * t * sum;
	const double pi = 2.0 * (HALF_PI_HIGH + HALF_PI_MIDDLE);
	return x >= 0.0 ? angle : (y >= 0.0 ? pi : -pi) - angle;
}

} // namespace undergrowth

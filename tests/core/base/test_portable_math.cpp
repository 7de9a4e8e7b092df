#include "../golden.hpp"
#include "base/portable_math.hpp"
#include "base/random.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

using namespace undergrowth;

namespace {

constexpr double TOLERANCE = 1e-14;
constexpr int POINTS = 200000;

/// The number `index` of a fixed stream, within ±size.
double sample(int index, double size) {
	const double fine = static_cast<double>(signed_noise(1, static_cast<uint64_t>(index)));
	const double finer = static_cast<double>(signed_noise(2, static_cast<uint64_t>(index)));
	return size * (fine + finer * 0x1p-24) / (1.0 + 0x1p-24);
}

} // namespace

TEST_CASE("portable sine and cosine agree with the C library's up to a million radians") {
	double worst = 0.0;
	for (const double size : { 1e-3, 1.0, 10.0, 1e3, 1e6 }) {
		for (int i = 0; i < POINTS; i++) {
			const double angle = sample(i, size);
			worst = std::fmax(worst, std::fabs(portable_sin(angle) - std::sin(angle)));
			worst = std::fmax(worst, std::fabs(portable_cos(angle) - std::cos(angle)));
		}
	}
	CHECK(worst < TOLERANCE);
}

TEST_CASE("a combined sine and cosine have the bits of separate ones") {
	const double infinite = std::numeric_limits<double>::infinity();
	int others = 0;
	for (int i = 0; i < POINTS; i++) {
		for (const double angle : { sample(i, 8.0), sample(i, 3e6), (i - POINTS / 2) * 0.78539816339744830962 }) {
			const SineAndCosine both = portable_sine_and_cosine(angle);
			const bool is_same = both.sine == portable_sin(angle) && both.cosine == portable_cos(angle) &&
					std::signbit(both.sine) == std::signbit(portable_sin(angle)) &&
					std::signbit(both.cosine) == std::signbit(portable_cos(angle));
			others += is_same ? 0 : 1;
		}
	}
	CHECK(others == 0);
	CHECK(std::isnan(portable_sine_and_cosine(infinite).sine));
	CHECK(std::isnan(portable_sine_and_cosine(infinite).cosine));
}

TEST_CASE("portable functions have the same bits on every platform") {
	constexpr uint64_t GOLDEN = 0x469fc7b457f927afull;
	GoldenHash hash;
	for (int i = 0; i < POINTS; i++) {
		const double angle = sample(i, i % 2 == 0 ? 1.0 : 1e3);
		const double values[] = { portable_sin(angle), portable_cos(angle), portable_tan(sample(i, 1.5)),
			portable_exp(sample(i, i % 2 == 0 ? 0.5 : 300.0)), portable_atan2(angle, sample(i + 1, 1.0)) };
		hash.add(values, 5);
	}
	CHECK(hash.value() == GOLDEN);
}

TEST_CASE("portable sine and cosine are correct at the borders of the quadrants") {
	constexpr double QUARTER = 0.78539816339744830962;
	double worst = 0.0;
	for (int i = -1000; i <= 1000; i++) {
		for (const double shift : { -1e-9, 0.0, 1e-9 }) {
			const double angle = i * QUARTER + shift;
			worst = std::fmax(worst, std::fabs(portable_sin(angle) - std::sin(angle)));
			worst = std::fmax(worst, std::fabs(portable_cos(angle) - std::cos(angle)));
		}
	}
	CHECK(worst < TOLERANCE);
	CHECK(portable_sin(0.0) == 0.0);
	CHECK(portable_cos(0.0) == 1.0);
}

TEST_CASE("the portable logarithm and powers agree with the C library's") {
	double worst = 0.0;
	for (int i = 0; i < POINTS; i++) {
		const double value = std::exp(sample(i, 20.0));
		const double log = std::log(value);
		worst = std::fmax(worst, std::fabs(portable_log(value) - log) / std::fmax(1.0, std::fabs(log)));
		const double share = std::fabs(sample(2 * i, 1.0));
		const double power = 4.0 * std::fabs(sample(3 * i, 1.0));
		worst = std::fmax(worst, std::fabs(portable_pow(share, power) - std::pow(share, power)));
	}
	CHECK(worst < TOLERANCE);
}

TEST_CASE("powers of 0 and 1, and logarithms of invalid numbers") {
	CHECK(portable_pow(0.0, 0.5) == 0.0);
	CHECK(portable_pow(0.0, 0.0) == 1.0);
	CHECK(std::isinf(portable_pow(0.0, -1.0)));
	CHECK(portable_pow(1.0, 1e9) == 1.0);
	CHECK(std::isnan(portable_log(0.0)));
	CHECK(std::isnan(portable_log(-1.0)));
	CHECK(std::isnan(portable_pow(-1.0, 0.5)));
}

TEST_CASE("the portable angle of a direction agrees with the C library's") {
	double worst = 0.0;
	for (int i = 0; i < POINTS; i++) {
		const double x = sample(2 * i, 3.0);
		const double y = sample(2 * i + 1, 3.0);
		worst = std::fmax(worst, std::fabs(portable_atan2(y, x) - std::atan2(y, x)));
	}
	CHECK(worst < TOLERANCE);
	CHECK(portable_atan2(0.0, 0.0) == 0.0);
	CHECK(portable_atan2(0.0, 2.0) == 0.0);
	CHECK(portable_atan2(0.0, -2.0) == doctest::Approx(std::atan2(0.0, -2.0)));
	CHECK(portable_atan2(-1.0, 0.0) == doctest::Approx(std::atan2(-1.0, 0.0)));
}

TEST_CASE("portable tangent agrees with the C library's away from its poles") {
	double worst = 0.0;
	for (int i = 0; i < POINTS; i++) {
		const double angle = sample(i, 1.5);
		const double expected = std::tan(angle);
		worst = std::fmax(worst, std::fabs(portable_tan(angle) - expected) / (1.0 + std::fabs(expected)));
	}
	CHECK(worst < TOLERANCE);
}

TEST_CASE("portable exponential agrees with the C library's") {
	double worst = 0.0;
	for (const double size : { 1e-3, 1.0, 30.0, 700.0 }) {
		for (int i = 0; i < POINTS; i++) {
			const double exponent = sample(i, size);
			const double expected = std::exp(exponent);
			worst = std::fmax(worst, std::fabs(portable_exp(exponent) - expected) / expected);
		}
	}
	CHECK(worst < TOLERANCE);
	CHECK(portable_exp(0.0) == 1.0);
}

TEST_CASE("portable exponential saturates instead of overflowing") {
	CHECK(portable_exp(1e6) == std::numeric_limits<double>::max());
	CHECK(portable_exp(-1e6) == 0.0);
	CHECK(portable_exp(std::numeric_limits<double>::infinity()) == std::numeric_limits<double>::max());
	CHECK(std::isfinite(portable_exp(709.7827)));
	CHECK(portable_exp(-740.0) > 0.0);
}

TEST_CASE("portable functions of absurd angles stay in range, and of NaN are NaN") {
	CHECK(std::fabs(portable_sin(1e300)) <= 1.0);
	CHECK(std::fabs(portable_cos(-1e300)) <= 1.0);
	CHECK(std::isnan(portable_sin(std::numeric_limits<double>::infinity())));
	CHECK(std::isnan(portable_cos(std::numeric_limits<double>::quiet_NaN())));
	CHECK(std::isnan(portable_tan(std::numeric_limits<double>::quiet_NaN())));
	CHECK(std::isnan(portable_exp(std::numeric_limits<double>::quiet_NaN())));
}

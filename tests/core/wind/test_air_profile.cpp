#include "wind/air_profile.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

using namespace undergrowth;

TEST_CASE("above open ground the wind grows with the height's logarithm") {
	for (const double roughness : { 0.001, 0.03, 0.4 }) {
		for (double height = 10.0 * roughness; height < 50.0; height *= 1.3) {
			const double expected = std::log(height / roughness) / std::log(10.0 / roughness);
			REQUIRE(std::fabs(open_ground_speed(height, roughness) - expected) < 1e-4);
		}
		CHECK(open_ground_speed(0.0, roughness) == 0.0);
		const double edge = 10.0 * roughness;
		CHECK(open_ground_speed(0.5 * edge, roughness) == doctest::Approx(0.5 * open_ground_speed(edge, roughness)));
		const double gusts = open_ground_gusts(edge, roughness);
		CHECK(open_ground_gusts(20.0 * edge, roughness) == doctest::Approx(gusts)); // The same at all heights,
		// except within the roughness.
		CHECK(open_ground_gusts(0.25 * edge, roughness) == doctest::Approx(0.25 * gusts));
	}
	CHECK(open_ground_gusts(1.0, 0.03) / open_ground_speed(1.0, 0.03) == doctest::Approx(0.25).epsilon(0.01));
}

TEST_CASE("the tops of a canopy have the wind of the displaced law, and its depths less") {
	CHECK(canopy_top_speed(0.7) == doctest::Approx(0.224).epsilon(0.005));
	CHECK(canopy_speed(2.0, 0.7) == doctest::Approx(std::log((2.0 - 0.49) / 0.07) / std::log((10.0 - 0.49) / 0.07)));
	CHECK(canopy_speed(0.35, 0.7, 2.0) == doctest::Approx(canopy_top_speed(0.7) * std::exp(-1.0)));
	double before = 0.0;
	for (double height = 0.0; height < 5.0; height += 0.01) {
		REQUIRE(canopy_speed(height, 0.7) > before);
		before = canopy_speed(height, 0.7);
	}
}

TEST_CASE("profiles with invalid or out-of-range numbers are finite and not below 0") {
	constexpr double NONE = std::numeric_limits<double>::quiet_NaN();
	constexpr double INF = std::numeric_limits<double>::infinity();
	for (const double a : { NONE, INF, -INF, -1.0, 0.0, 1e-30, 1.0, 1e30 }) {
		for (const double b : { NONE, INF, -INF, -1.0, 0.0, 1e-30, 1.0, 1e30 }) {
			for (const double value : { open_ground_speed(a, b), open_ground_gusts(a, b), canopy_speed(a, b) }) {
				REQUIRE(std::isfinite(value));
				REQUIRE(value >= 0.0);
			}
		}
	}
}

TEST_CASE("Beaufort's numbers have the speeds of weather reports") {
	const int tenths[] = { 0, 10, 24, 44, 67, 94, 123, 156, 190, 226, 264, 305 };
	for (int number = 0; number < 12; number++) {
		CHECK(std::fabs(beaufort_speed(number) - 0.1 * tenths[number]) < 0.2);
		CHECK(beaufort_of(beaufort_speed(number)) == number);
	}
	CHECK(beaufort_of(100.0) == 12);
	CHECK(beaufort_of(std::numeric_limits<double>::quiet_NaN()) == 0);
}

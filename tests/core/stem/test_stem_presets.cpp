#include "stems.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace undergrowth;
using doctest::Approx;

namespace {

/// A plant in botanical terms, with the results of a separate program; columns have the same rounding.
struct Preset {
	const char *name;
	float length; ///< m.
	float diameter; ///< mm, width of a blade.
	float thickness; ///< mm, 0: round.
	float taper;
	float hollow;
	float density; ///< kg/m³.
	float head; ///< g.
	float head_area; ///< cm², drag coefficient included.
	float leaves; ///< g.
	float leaf_area; ///< cm².
	float frequency; ///< Hz.
	double modulus; ///< GPa.
	double rounded; ///< GPa: half of the modulus's last digit.
	double buckling_share;
	double second; ///< Frequency of the second mode over that of the first.
	double wind_30; ///< m/s for a tip at 30°,
	double wind_60; ///< and at 60°.
	double air_damping; ///< Damping ratio across a wind of 5 m/s.
};

constexpr Preset PRESETS[] = {
	{ "meadow grass", .6f, 2, 0, .5f, 0, 500, .15f, 3.6f, .2f, 3, 1.6f, 6, .5, .20, 5.6, 3.6, 8.2, .34 },
	{ "lawn blade", .1f, 4, .25f, .8f, 0, 660, 0, 0, 0, 0, 9, 1.5, .05, .05, 4.9, 3.9, 8.9, .25 },
	{ "long blade", .5f, 6, .6f, .85f, 0, 600, 0, 0, 0, 0, 1.4f, 4.3, .05, .31, 5.4, 2.0, 4.5, .71 },
	{ "reed", 2.1f, 9, 0, .6f, .72f, 680, 6, 60, 12, 150, .7f, 9, .5, .28, 5.3, 4.1, 9.2, .36 },
	{ "cattail", 1.8f, 12, 0, .5f, .6f, 560, 28, 33, 0, 0, .8f, 5, .5, .24, 8.2, 10.7, 24, .05 },
	{ "tulip", .45f, 7, 0, .15f, 0, 1000, 12, 21, 2, 12, 1.4f, .5, .05, .27, 10, 10.3, 23.5, .03 },
	{ "bellflower", .6f, 3.5f, 0, .5f, 0, 730, 1.5f, 16, .4f, 4, 1.4f, 4, .5, .24, 7.5, 4.8, 11, .18 },
	{ "wheat", .8f, 4, 0, .35f, .8f, 770, 2, 9, .6f, 6, 1.3f, 7, .5, .20, 9.1, 6.6, 15, .12 },
	{ "poppy", .65f, 3, 0, .4f, 0, 780, .8f, 25, .5f, 4, 1.3f, 4, .5, .25, 6.6, 3.3, 7.5, .42 },
	{ "oxeye daisy", .5f, 2.8f, 0, .4f, 0, 820, 1, 9, .5f, 3, 1.7f, 4, .5, .20, 7.4, 6, 13.6, .12 },
	{ "fern frond", .8f, 5, 0, .8f, 0, 1000, 0, 0, 10, 135, 1.1f, 3, .5, .34, 3.9, 2.9, 6.6, .28 },
};

StemBeam beam_of(const Preset &preset) {
	StemBeam beam;
	beam.length = preset.length;
	beam.diameter = 1e-3f * preset.diameter;
	if (preset.thickness > 0.0f) {
		beam.section = StemBeam::Section::blade;
		beam.thickness = 1e-3f * preset.thickness;
		beam.drag_coefficient = 1.5f;
	}
	beam.taper = preset.taper;
	beam.hollow = preset.hollow;
	beam.density = preset.density;
	beam.head_mass = 1e-3f * preset.head;
	beam.head_drag_area = 1e-4f * preset.head_area;
	beam.leaf_mass = 1e-3f * preset.leaves;
	beam.leaf_drag_area = 1e-4f * preset.leaf_area;
	beam.natural_frequency = preset.frequency;
	return beam;
}

double wind_for(const StemConstants &stem, double angle) {
	const double across = std::cos(angle);
	return std::sqrt(std::sin(angle) / (across * across) / stem.air_slope);
}

} // namespace

TEST_CASE("stems with declared frequencies have the moduli and the bends in wind of the table") {
	constexpr double RATIO = 0.02;
	constexpr double WIND = 0.03;
	constexpr double DAMPING = 0.06; // Its column has two digits.
	for (const Preset &preset : PRESETS) {
		CAPTURE(preset.name);
		const StemSolution solution = solve_stem(beam_of(preset));
		const StemConstants &stem = solution.constants;
		CHECK(std::abs(1e-9 * solution.youngs_modulus - preset.modulus) <= preset.rounded);
		CHECK(solution.buckling_share == Approx(preset.buckling_share).epsilon(0.04).scale(0.0));
		CHECK(solution.frequencies[1] / solution.frequencies[0] == Approx(preset.second).epsilon(RATIO).scale(0.0));
		CHECK(wind_for(stem, PI / 6.0) == Approx(preset.wind_30).epsilon(WIND).scale(0.0));
		CHECK(wind_for(stem, PI / 3.0) == Approx(preset.wind_60).epsilon(WIND).scale(0.0));
		const StemMode &mode = stem.mode[0];
		const double damping = mode.air_drag * 5.0 / (2.0 * mode.mass * mode.frequency);
		CHECK(std::abs(damping - preset.air_damping) <= std::max(0.005, DAMPING * preset.air_damping));
	}
}

TEST_CASE("of the same material a tall stem swings slowly and a low one fast") {
	StemBeam beam;
	beam.natural_frequency = 0.0f;
	beam.diameter = 0.002f;
	double before = 1e9;
	for (const float length : { 0.02f, 0.1f, 0.3f, 0.6f }) {
		beam.length = length;
		const StemSolution solution = solve_stem(beam);
		REQUIRE(solution.fault == StemFault::none);
		CHECK(solution.frequencies[0] < 0.3 * before);
		before = solution.frequencies[0];
	}
}

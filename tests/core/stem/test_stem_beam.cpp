#include "ritz_beam.hpp"
#include "stems.hpp"

#include "figures.hpp"
#include "golden.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace undergrowth;
using doctest::Approx;

namespace {

constexpr double BEAM = 1e-3; // Relative to closed forms with four digits.
constexpr double FINE = 2e-4; // Of frequencies, relative to Ritz; the largest error is that of a nearly pointed tip.
constexpr double DECLARED = 1e-6; // Of a declared frequency: rounding of the beam.
constexpr double GREENHILL = 2e-3;

/// The load under which a stem would fall: m·g·L²/(EI).
double critical_load(const StemBeam &beam) {
	const StemSolution solution = solve_stem(beam);
	const double weight = mass_of(beam) * STANDARD_GRAVITY;
	return weight * beam.length * beam.length / (solution.youngs_modulus * root_bending(beam)) /
			solution.buckling_share;
}

} // namespace

TEST_CASE("frequencies of uniform stems match Euler and Bernoulli, with and without heads") {
	const double expected[][3] = { { 0.0, 3.5160, 22.0345 }, { 0.5, 2.016, 16.901 }, { 2.0, 1.158, 15.861 } };
	for (const auto &[head, first, second] : expected) {
		const StemBeam beam = stiff_stem(0.0, head);
		const StemSolution solution = solve_stem(beam);
		REQUIRE(solution.fault == StemFault::none);
		const double rate = beam_rate(beam, solution.youngs_modulus);
		CHECK(solution.frequencies[0] / rate == Approx(first).epsilon(BEAM).scale(0.0));
		CHECK(solution.frequencies[1] / rate == Approx(second).epsilon(BEAM).scale(0.0));
		if (head == 0.0) {
			figures::record(figures::STEMS, "first frequency of a uniform stem, √(EI/mL³)", first,
					solution.frequencies[0] / rate, 4);
			figures::record(figures::STEMS, "second", second, solution.frequencies[1] / rate, 4);
		}
	}
}

TEST_CASE("frequencies of tapered stems with heads and leaves match a finer method") {
	for (const double taper : { 0.0, 0.3, 0.6, 0.9 }) {
		for (const double head : { 0.0, 0.5, 2.0 }) {
			StemBeam beam = stem_of(taper, head);
			beam.head_centre = 0.04f;
			beam.head_inertia = 1e-7f;
			beam.leaf_mass = 0.002f;
			const StemSolution solution = solve_stem(beam);
			const RitzBeam ritz(beam, solution.youngs_modulus);
			CAPTURE(taper);
			CAPTURE(head);
			CHECK(solution.frequencies[0] == Approx(ritz.frequency).epsilon(FINE).scale(0.0));
			CHECK(solution.frequencies[1] == Approx(ritz.second).epsilon(FINE).scale(0.0));
			for (const double share :
					{ solution.frequencies[0] / ritz.frequency, solution.frequencies[1] / ritz.second }) {
				figures::record_error(
						figures::STEMS, "both, of stems that taper and carry heads and leaves", BEAM, share - 1.0);
			}
		}
	}
}

TEST_CASE("a stem is stable up to Greenhill's load") {
	const double expected[][3] = { { 0.0, 0.0, 7.8374 }, { 0.0, 0.5, 3.0691 }, { 0.0, 2.0, 1.0730 },
		{ 0.6, 0.0, 7.0638 } };
	for (const auto &[taper, head, load] : expected) {
		const double found = critical_load(stem_of(taper, head));
		CHECK(found == Approx(load).epsilon(GREENHILL).scale(0.0));
		figures::record_error(
				figures::STEMS, "weight under which a stem falls (Greenhill)", GREENHILL, found / load - 1.0);
	}
}

TEST_CASE("weight slows a swing") {
	const double expected[][2] = { { 1.0, 0.93427 }, { 2.0, 0.86349 }, { 4.0, 0.70050 }, { 6.0, 0.48500 },
		{ 7.0, 0.32752 } };
	StemBeam beam = stem_of(0.0, 0.0, 0.0);
	const double l = beam.length;
	for (const auto &[load, share] : expected) {
		beam.youngs_modulus =
				static_cast<float>(mass_of(beam) * STANDARD_GRAVITY * l * l / (load * root_bending(beam)));
		const double rate = 3.51602 * beam_rate(beam, beam.youngs_modulus);
		CHECK(solve_stem(beam).frequencies[0] / rate == Approx(share).epsilon(BEAM).scale(0.0));
	}
}

TEST_CASE("a stem that is too heavy falls and has a fault") {
	StemBeam beam = stem_of(0.0, 0.0, 0.0);
	const double l = beam.length;
	const double critical = mass_of(beam) * STANDARD_GRAVITY * l * l / (7.8373 * root_bending(beam));
	beam.youngs_modulus = static_cast<float>(1.001 * critical);
	CHECK(solve_stem(beam).fault == StemFault::none);
	beam.youngs_modulus = static_cast<float>(0.999 * critical);
	CHECK(solve_stem(beam).fault == StemFault::falls);
	CHECK(solve_stem(beam).constants.dead_slope == 1.0f);
}

TEST_CASE("a declared frequency includes the weight, and its modulus gives the same stem again") {
	for (const double taper : { 0.0, 0.6, 0.9 }) {
		for (const double head : { 0.0, 2.0 }) {
			for (const double declared : { 0.3, 1.4, 4.0 }) {
				StemBeam beam = stem_of(taper, head, declared);
				const StemSolution solution = solve_stem(beam);
				REQUIRE(solution.fault == StemFault::none);
				const double wanted = 2.0 * PI * beam.natural_frequency;
				CHECK(solution.frequencies[0] == Approx(wanted).epsilon(DECLARED).scale(0.0));
				CHECK(solution.constants.mode[0].frequency == Approx(wanted).epsilon(DECLARED).scale(0.0));
				beam.natural_frequency = 0.0f;
				beam.youngs_modulus = static_cast<float>(solution.youngs_modulus);
				if (solution.buckling_share < 0.9) { // Nearer, the precision of a float decides.
					CHECK(solve_stem(beam).frequencies[0] == Approx(wanted).epsilon(10.0 * DECLARED).scale(0.0));
				}
			}
		}
	}
}

TEST_CASE("small bends match those of a beam with a load at its tip and with a distributed load") {
	StemBeam beam = stiff_stem();
	const double modulus = 1e12 * root_bending(beam);
	for (const int modes : { 1, 2 }) {
		beam.modes = modes;
		beam.wind_weights.clear();
		const StemConstants even = solve_stem(beam).constants;
		beam.wind_weights = { 0.0f, 0.0f, 0.0f, 1.0f };
		const StemConstants tip = solve_stem(beam).constants;
		CHECK(even.dead_slope * modulus == Approx(1.0 / 6.0).epsilon(BEAM).scale(0.0));
		CHECK(tip.dead_slope * modulus == Approx(1.0 / 2.0).epsilon(BEAM).scale(0.0));
		double even_bend = 0.0;
		double tip_bend = 0.0;
		for (int k = 0; k < modes; k++) {
			even_bend += even.deflection[4][k] * even.mode[k].dead_share * even.dead_slope;
			tip_bend += tip.deflection[4][k] * tip.mode[k].dead_share * tip.dead_slope;
		}
		CHECK(even_bend * modulus == Approx(1.0 / 8.0).epsilon(BEAM).scale(0.0));
		CHECK(tip_bend * modulus == Approx(1.0 / 3.0).epsilon(BEAM).scale(0.0));
	}
}

TEST_CASE("a load along the stem has the weight of the reference") {
	CHECK(solve_stem(stiff_stem()).constants.axial_share == Approx(0.75).epsilon(BEAM).scale(0.0));
	CHECK(solve_stem(stiff_stem(0.6)).constants.axial_share == Approx(0.598).epsilon(BEAM).scale(0.0));
}

TEST_CASE("wind on a head above the tip also turns the head") {
	StemBeam beam = stiff_stem();
	beam.wind_weights = { 0.0f, 0.0f, 0.0f, 1.0f };
	beam.head_centre = 0.1f;
	const StemConstants stem = solve_stem(beam).constants;
	CHECK(stem.dead_slope * 1e12 * root_bending(beam) == Approx(0.5 + 0.1).epsilon(BEAM).scale(0.0));
	CHECK(stem.deflection[4][0] ==
			Approx(stem.deflection[3][0] + 0.1 * stem.mode[0].tip_slope).epsilon(1e-6).scale(0.0));
}

TEST_CASE("many masses and drags at points match distributed ones") {
	StemBeam spread = stem_of(0.4, 0.3);
	spread.leaf_mass = 0.003f;
	spread.leaf_drag_area = 0.004f;
	StemBeam placed = stem_of(0.4, 0.3);
	for (int i = 0; i < 100; i++) {
		placed.loads.push_back({ (static_cast<float>(i) + 0.5f) / 100.0f, 0.00003f, 0.00004f });
	}
	const StemSolution one = solve_stem(spread);
	const StemSolution other = solve_stem(placed);
	CHECK(other.youngs_modulus == Approx(one.youngs_modulus).epsilon(BEAM).scale(0.0));
	CHECK(other.constants.dead_slope == Approx(one.constants.dead_slope).epsilon(BEAM).scale(0.0));
	CHECK(other.constants.air_slope == Approx(one.constants.air_slope).epsilon(BEAM).scale(0.0));
	CHECK(other.constants.axial_share == Approx(one.constants.axial_share).epsilon(BEAM).scale(0.0));
	CHECK(other.constants.mode[0].air_drag == Approx(one.constants.mode[0].air_drag).epsilon(BEAM).scale(0.0));
	for (int j = 0; j < STEM_SHAPE_TERMS; j++) {
		CHECK(std::abs(other.constants.shape[j][2] - one.constants.shape[j][2]) < 0.01f);
	}
}

TEST_CASE("air bends the tip equally, for any joints with wind in newtons") {
	StemBeam beam = stem_of(0.5, 0.5);
	const double slope = solve_stem(beam).constants.air_slope;
	for (const int modes : { 1, 2 }) {
		beam.modes = modes;
		beam.wind_weights = { 1.0f, 0.0f, 0.0f, 0.2f };
		const StemConstants stem = solve_stem(beam).constants;
		CHECK(stem.air_slope == Approx(slope).epsilon(1e-6).scale(0.0));
		double tip = 0.0;
		for (int k = 0; k < modes; k++) {
			tip += stem.mode[k].tip_slope * stem.mode[k].air_share;
		}
		CHECK(tip == Approx(1.0).epsilon(1e-6).scale(0.0));
	}
}

TEST_CASE("neither frequencies nor bends depend on the number of joints") {
	StemBeam beam = stem_of(0.5, 0.5);
	const StemSolution four = solve_stem(beam);
	beam.joints = 1;
	const StemSolution one = solve_stem(beam);
	CHECK(one.frequencies[1] == four.frequencies[1]);
	CHECK(one.constants.dead_slope == four.constants.dead_slope);
	for (int j = 0; j < STEM_SHAPE_TERMS; j++) {
		for (int k = 0; k < 4; k++) {
			CHECK(one.constants.shape[j][k] == four.constants.shape[j][k]);
		}
	}
}

TEST_CASE("a hollow stem swings faster than a solid one of the same material") {
	StemBeam beam = stiff_stem();
	const double solid = solve_stem(beam).frequencies[0];
	beam.hollow = 0.8f; // Stiffness decreases by 0.8⁴, mass by 0.8².
	CHECK(solve_stem(beam).frequencies[0] / solid == Approx(std::sqrt(1.0 + 0.64)).epsilon(BEAM).scale(0.0));
}

TEST_CASE("the constants of a stem have the same bits everywhere") {
	GoldenHash hash;
	for (const double taper : { 0.0, 0.5, 0.9 }) {
		for (const int modes : { 1, 2 }) {
			StemBeam beam = stem_of(taper, taper);
			beam.modes = modes;
			beam.nods = modes == 2;
			beam.head_drag_area = 0.001f;
			beam.head_centre = 0.01f;
			beam.loads = { { 0.3f, 0.0002f, 0.0005f } };
			const StemSolution solution = solve_stem(beam);
			hash.add(&solution.constants, 1).add(solution.frequencies, 2).add(&solution.youngs_modulus, 1);
		}
	}
	CHECK(hash.value() == 13342818083396014621ull);
}

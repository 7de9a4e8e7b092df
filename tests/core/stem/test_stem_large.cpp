#include "steady_chain.hpp"
#include "stems.hpp"

#include "stem/stem_bones.hpp"
#include "stem/stem_shape.hpp"

#include "figures.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace undergrowth;
using doctest::Approx;

namespace {

constexpr double DEGREE = PI / 180.0;
constexpr double TO_45 = 0.01; // Of the length; so is the next.
constexpr double TO_75 = 0.025;
constexpr double DRAG_RATIO = 0.02;

/// Max distance of a drawn stem from a chain, in stem lengths.
double distance_to(const SteadyChain &chain, const StemConstants &stem, const SteadyStem &steady) {
	double max = 0.0;
	for (int i = 1; i <= 32; i++) {
		const float x = static_cast<float>(i) / 32.0f;
		const glm::vec3 place = stem_place(stem, steady.amplitudes, x).centre;
		max = std::max(max, glm::distance(chain.place(x), glm::dvec2(place.x, place.y)));
	}
	return max;
}

void record_shape(const std::string &wind, const SteadyChain &chain, double far) {
	const bool is_slight = chain.tip_angle() < 45.0 * DEGREE;
	CHECK(far < (is_slight ? TO_45 : TO_75));
	const std::string what =
			"shape in steady wind in " + wind + ", tip to " + (is_slight ? "45" : "75") + "°, of the length";
	figures::record_error(figures::STEMS, what, is_slight ? TO_45 : TO_75, far);
}

std::vector<StemBeam> varied_stems() {
	std::vector<StemBeam> stems = { stem_of(), stem_of(0.6), stem_of(0.6, 0.5), stem_of(0.3, 2.0, 0.8), stem_of(0.9),
		stem_of(0.0, 0.0, 0.8), stem_of(0.5, 0.0, 8.0) };
	StemBeam flower = stem_of(0.4, 0.3, 1.3);
	flower.head_drag_area = 0.0015f;
	flower.head_centre = 0.02f;
	flower.leaf_mass = 0.001f;
	flower.leaf_drag_area = 0.0003f;
	stems.push_back(flower);
	return stems;
}

} // namespace

TEST_CASE("a stem in a steady wind in newtons has the shape of a chain of 128 links") {
	for (StemBeam beam : varied_stems()) {
		for (const int modes : { 1, 2 }) {
			beam.modes = modes;
			const StemSolution solution = solve_stem(beam);
			REQUIRE(solution.fault == StemFault::none);
			SteadyChain chain(beam, solution.youngs_modulus);
			for (const double slope : { 0.2, 0.5, 0.9, 1.5, 2.2 }) {
				chain.settle_dead(slope / solution.constants.dead_slope);
				const double far = distance_to(chain, solution.constants, in_newtons(solution.constants, slope));
				CAPTURE(beam.taper);
				CAPTURE(slope);
				CHECK(chain.tip_angle() < 77.0 * DEGREE);
				record_shape("newtons", chain, far);
			}
		}
	}
}

TEST_CASE("a stem in steady air has the shape of a chain of 128 links") {
	for (const StemBeam &beam : varied_stems()) {
		const StemSolution solution = solve_stem(beam);
		const StemConstants stem = in_air(solution.constants);
		SteadyChain chain(beam, solution.youngs_modulus);
		for (const double slope : { 0.3, 1.0, 1.5, 4.0, 8.0 }) {
			chain.settle_air(std::sqrt(slope / stem.air_slope));
			CAPTURE(beam.taper);
			CAPTURE(slope);
			const double far = distance_to(chain, stem, in_wind(stem, slope));
			record_shape("m/s", chain, far);
		}
	}
}

TEST_CASE("the tip under a load at the tip matches the elastica") {
	const double expected[][3] = { { 1.0, 0.302, 0.944 }, { 2.0, 0.494, 0.839 }, { 5.0, 0.714, 0.612 } };
	StemBeam beam = stiff_stem();
	beam.joints = 8;
	beam.wind_weights = { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f };
	const StemConstants stem = solve_stem(beam).constants;
	for (const auto &[load, x, y] : expected) {
		StemLink links[MAX_STEM_JOINTS];
		const glm::vec3 tip = stem_links(stem, in_newtons(stem, 0.5 * load).amplitudes, links);
		const double far = glm::distance(glm::dvec2(tip.x, tip.y), glm::dvec2(x, y));
		CHECK(far < 0.01);
		figures::record_error(figures::STEMS, "tip under a load there, of an elastica, of the length", 0.01, far);
	}
}

TEST_CASE("the drag of a blade decreases with its bend, as measured") {
	const double expected[][2] = { { 1.0, 0.9748 }, { 10.0, 0.5236 }, { 50.0, 0.2484 }, { 100.0, 0.1918 } };
	const StemConstants stem = in_air(solve_stem(stiff_stem()).constants);
	for (const auto &[cauchy, ratio] : expected) {
		const SteadyStem steady = in_wind(stem, cauchy / 6.0);
		double sum = 0.0;
		for (int i = 0; i < 400; i++) {
			const glm::vec2 bend = stem_bend(stem, steady.amplitudes, (static_cast<float>(i) + 0.5f) / 400.0f);
			const double n = glm::dot(bend, bend);
			sum += std::pow((1.0 - n) / (1.0 + n), 3.0) / 400.0;
		}
		CHECK(sum == Approx(ratio).epsilon(DRAG_RATIO).scale(0.0));
		figures::record_error(
				figures::STEMS, "drag of a bent blade, to a Cauchy number of 100", DRAG_RATIO, sum / ratio - 1.0);
	}
}

TEST_CASE("six terms are enough for the shape of a tapered stem") {
	constexpr double PATH = 5e-4; // Of the length.
	for (const float taper : { 0.0f, 0.6f, 0.9f }) {
		StemBeam beam = stiff_stem(taper);
		beam.wind_weights = { 0.0f, 0.0f, 0.0f, 1.0f };
		const StemConstants stem = solve_stem(beam).constants;
		// ψ' = (1 - x)/(1 - taper·x)⁴, up to a factor.
		constexpr int STEPS = 6400;
		std::vector<double> exact = { 0.0 };
		for (int i = 0; i < STEPS; i++) {
			const double x = (i + 0.5) / STEPS;
			exact.push_back(exact.back() + (1.0 - x) / std::pow(1.0 - taper * x, 4.0));
		}
		double path = 0.0;
		double max = 0.0;
		const glm::vec2 one(1.0f, 0.0f);
		StemConstants linear = stem;
		for (auto &term : linear.shape) {
			term[2] = 0.0f;
			term[3] = 0.0f;
		}
		for (int i = 0; i < STEPS; i++) {
			const float x = (static_cast<float>(i) + 0.5f) / STEPS;
			const double drawn = stem_bend(linear, &one, x).x / stem.mode[0].tip_slope;
			// For a tip of 45°, where a bend of 0.414 turns by twice its change.
			path += 2.0 * 0.414 * (drawn - 0.5 * (exact[i] + exact[i + 1]) / exact[STEPS]) / STEPS;
			max = std::max(max, std::abs(path));
		}
		CAPTURE(taper);
		CHECK(max < PATH);
	}
}

#include "stems.hpp"

#include "stem/stem_bones.hpp"
#include "stem/stem_shape.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace undergrowth;

namespace {

bool are_finite(const float *numbers, int count) {
	for (int i = 0; i < count; i++) {
		if (!std::isfinite(numbers[i])) {
			return false;
		}
	}
	return true;
}

bool is_finite(const StemConstants &stem) {
	bool finite = are_finite(stem.shape[0], 4 * STEM_SHAPE_TERMS) &&
			are_finite(stem.air_shape[0], 2 * STEM_SHAPE_TERMS) &&
			are_finite(stem.deflection[0], MAX_STEM_MODES * (MAX_STEM_JOINTS + 1));
	for (const StemMode &mode : stem.mode) {
		finite = finite && are_finite(&mode.frequency, 12) && mode.mass > 0.0f && mode.stiffness > 0.0f &&
				mode.frequency > 0.0f;
	}
	return finite && stem.dead_slope > 0.0f && std::isfinite(stem.dead_slope) && stem.air_slope > 0.0f &&
			std::isfinite(stem.air_slope) && stem.axial_share > 0.0f && stem.axial_share <= 1.0f;
}

/// True if no point bends far beyond the tip or against the wind, for any bend of the tip.
bool is_tame(const StemConstants &stem, bool is_in_air) {
	for (const double slope : { 0.5, 2.0, 10.0, 1e4 }) {
		const SteadyStem steady = is_in_air ? in_wind(stem, slope) : in_newtons(stem, slope);
		for (int i = 1; i <= 32; i++) {
			const float bend = stem_bend(stem, steady.amplitudes, static_cast<float>(i) / 32.0f).x;
			if (!(bend > -0.15f && bend < 2.5f)) {
				return false;
			}
		}
	}
	return true;
}

} // namespace

TEST_CASE("stable stems of all sizes have sound constants") {
	static_assert(sizeof(StemMode) == 12 * sizeof(float), "all of them are looked at");
	for (const float length : { 0.02f, 0.3f, 2.0f, 10.0f }) {
		for (const float taper : { 0.0f, 0.5f, 0.9f }) {
			for (const float head : { 0.0f, 0.5f, 2.0f }) {
				for (const float frequency : { 0.05f, 1.5f, 30.0f }) {
					for (const int modes : { 1, 2 }) {
						StemBeam beam;
						beam.length = length;
						beam.diameter = 0.008f * length;
						beam.taper = taper;
						beam.modes = modes;
						beam.natural_frequency = frequency;
						beam.head_mass = head * static_cast<float>(mass_of(beam));
						beam.head_centre = 0.05f * length;
						const StemSolution solution = solve_stem(beam);
						CAPTURE(length);
						CAPTURE(taper);
						CAPTURE(head);
						CAPTURE(frequency);
						REQUIRE(solution.fault == StemFault::none);
						REQUIRE(is_finite(solution.constants));
						REQUIRE(solution.buckling_share < 1.0);
						REQUIRE(is_tame(solution.constants, false));
						REQUIRE(is_tame(in_air(solution.constants), true));
					}
				}
			}
		}
	}
}

TEST_CASE("wind on single joints is supported") {
	for (int joints = 1; joints <= MAX_STEM_JOINTS; joints++) {
		for (int only = 0; only < joints; only++) {
			for (const int modes : { 1, 2 }) {
				for (const double head : { 0.0, 5.0, 1e5 }) {
					StemBeam beam = stem_of(0.5, head);
					beam.joints = joints;
					beam.modes = modes;
					beam.wind_weights.assign(joints, 0.0f);
					beam.wind_weights[only] = 1.0f;
					const StemSolution solution = solve_stem(beam);
					REQUIRE(solution.fault == StemFault::none);
					REQUIRE(is_finite(solution.constants));
				}
			}
		}
	}
}

TEST_CASE("each invalid or out-of-range number has its own fault") {
	constexpr float NONE = std::numeric_limits<float>::quiet_NaN();
	constexpr float INF = std::numeric_limits<float>::infinity();
	const struct {
		float StemBeam::*number;
		StemFault fault;
	} numbers[] = {
		{ &StemBeam::length, StemFault::length },
		{ &StemBeam::diameter, StemFault::diameter },
		{ &StemBeam::taper, StemFault::taper },
		{ &StemBeam::hollow, StemFault::hollow },
		{ &StemBeam::density, StemFault::density },
		{ &StemBeam::drag_coefficient, StemFault::drag },
		{ &StemBeam::natural_frequency, StemFault::frequency },
		{ &StemBeam::frequency_deviation, StemFault::deviation },
		{ &StemBeam::damping_ratio, StemFault::damping },
		{ &StemBeam::head_mass, StemFault::head },
		{ &StemBeam::head_centre, StemFault::head },
		{ &StemBeam::head_inertia, StemFault::head },
		{ &StemBeam::head_drag_area, StemFault::head },
		{ &StemBeam::leaf_mass, StemFault::leaves },
		{ &StemBeam::leaf_drag_area, StemFault::leaves },
	};
	for (const auto &[number, fault] : numbers) {
		for (const float bad : { NONE, INF, -INF, -1.0f, 1e30f }) {
			StemBeam beam;
			beam.*number = bad;
			const StemSolution solution = solve_stem(beam);
			CHECK(solution.fault == fault);
			CHECK(solution.constants.dead_slope == 1.0f);
		}
	}
	StemBeam beam;
	beam.section = StemBeam::Section::blade;
	beam.thickness = NONE;
	CHECK(solve_stem(beam).fault == StemFault::thickness);
	beam = StemBeam();
	beam.natural_frequency = 0.0f;
	beam.youngs_modulus = NONE;
	CHECK(solve_stem(beam).fault == StemFault::stiffness);
	beam = StemBeam();
	beam.joints = 9;
	CHECK(solve_stem(beam).fault == StemFault::joints);
	beam = StemBeam();
	beam.modes = 0;
	CHECK(solve_stem(beam).fault == StemFault::modes);
}

TEST_CASE("inconsistent loads and weights have their own faults") {
	StemBeam beam;
	beam.loads = { { 1.5f, 0.001f, 0.0f } };
	CHECK(solve_stem(beam).fault == StemFault::loads);
	beam.loads = { { 0.5f, std::numeric_limits<float>::quiet_NaN(), 0.0f } };
	CHECK(solve_stem(beam).fault == StemFault::loads);
	beam.loads.clear();
	for (const std::vector<float> &weights : std::vector<std::vector<float>>{
				 { 1.0f }, { 0.0f, 0.0f, 0.0f, 0.0f }, { 1.0f, -1.0f, 0.0f, 1.0f }, { NAN, 1.0f, 1.0f, 1.0f } }) {
		beam.wind_weights = weights;
		CHECK(solve_stem(beam).fault == StemFault::weights);
	}
}

TEST_CASE("each fault describes the remedy") {
	for (int i = 1; i <= static_cast<int>(StemFault::falls); i++) {
		const std::string words = describe(static_cast<StemFault>(i));
		CHECK(words.size() > 30);
		CHECK((words.find(": use ") != std::string::npos || words.find(": increase ") != std::string::npos ||
				words.find(": set ") != std::string::npos));
	}
}

#include "../figures.hpp"
#include "../stem/steady_chain.hpp"
#include "../stem/stems.hpp"
#include "stem_plants.hpp"

#include "stem/stem_bones.hpp"
#include "stem/stem_shape.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace undergrowth;

namespace {

constexpr double DEGREE = PI / 180.0;
constexpr float STEP = 1.0f / 60.0f;
constexpr double FREQUENCY = 4.0; // Hz: weight has little effect, and steps follow the loads.
/// Of the length, for winds that give the tip linear slopes of up to 4.
constexpr double AIR_TOLERANCE_20 = 0.035, AIR_TOLERANCE_40 = 0.07;
constexpr double FORCE_TOLERANCE_20 = 0.06, FORCE_TOLERANCE_40 = 0.12;

std::vector<StemBeam> stems() {
	std::vector<StemBeam> all = { stem_of(0.0, 0.0, FREQUENCY), stem_of(0.6, 0.0, FREQUENCY),
		stem_of(0.9, 0.0, FREQUENCY), stem_of(0.6, 0.5, FREQUENCY) };
	all.back().head_drag_area = 0.005f;
	StemBeam culm = stem_of(0.5, 0.3, 1.3); // Its weight matters.
	culm.leaf_mass = 0.001f;
	culm.leaf_drag_area = 0.0003f;
	all.push_back(culm);
	return all;
}

/// Where the tip of a plant that leans by `lean` comes to rest in a wind towards x, in lengths and axes of its foot.
glm::dvec2 rest_of(const StemConstants &stem, double lean, float newtons, float speed, float down = 0.0f) {
	StemPlants plants(stem, 1, STEP);
	plants.set_rest(0, { static_cast<float>(std::tan(0.5 * lean)), 0.0f });
	const glm::vec2 air(speed, 0.0f);
	plants.apply_wind(newtons, &air);
	plants.use_newtons(speed == 0.0f);
	plants.use_air(speed > 0.0f);
	if (down != 0.0f) {
		plants.press(0, -down);
	}
	plants.run(60.0);
	glm::vec2 amplitudes[MAX_STEM_MODES] = {};
	for (int k = 0; k < stem.modes; k++) {
		amplitudes[k] = plants.place(0, k);
	}
	const glm::vec3 tip = stem_place(speed > 0.0f ? in_air(stem) : stem, amplitudes, 1.0f).centre;
	return { tip.x, tip.y };
}

void check_tips(double degrees, bool in_air_wind, double tolerance) {
	for (StemBeam beam : stems()) {
		beam.damping_ratio = 0.7f;
		const StemSolution solution = solve_stem(beam);
		REQUIRE(solution.fault == StemFault::none);
		const StemConstants &stem = solution.constants;
		SteadyChain chain(beam, solution.youngs_modulus);
		chain.lean(-degrees * DEGREE);
		for (const double slope : { 0.5, 1.0, 2.0, 3.0, 4.0 }) {
			const double speed = std::sqrt(slope / static_cast<double>(stem.air_slope));
			const double newtons = slope / static_cast<double>(stem.dead_slope);
			in_air_wind ? chain.settle_air(speed) : chain.settle_dead(newtons);
			const glm::dvec2 tip = rest_of(stem, -degrees * DEGREE, in_air_wind ? 0.0f : static_cast<float>(newtons),
					in_air_wind ? static_cast<float>(speed) : 0.0f);
			const double error = glm::distance(tip, chain.place(1.0));
			CAPTURE(beam.taper);
			CAPTURE(slope);
			CHECK(error < tolerance);
			figures::record_error(figures::STEMS,
					"tip of a stem that leans " + std::to_string(static_cast<int>(degrees)) + "° against a wind in " +
							(in_air_wind ? "m/s" : "newtons") + ", of its length",
					tolerance, error);
		}
	}
}

} // namespace

TEST_CASE("leaning stems nod under their own weight as chains of 128 links") {
	constexpr double TOLERANCE = 0.01; // Of the length.
	for (const double frequency : { 1.2, 2.0, 4.0 }) {
		for (StemBeam beam : { stem_of(0.6, 0.0, frequency), stem_of(0.3, 0.6, frequency) }) {
			beam.damping_ratio = 0.7f;
			beam.nods = true;
			const StemSolution solution = solve_stem(beam);
			REQUIRE(solution.fault == StemFault::none);
			for (const double degrees : { -40.0, 5.0, 15.0, 30.0, 45.0, 60.0 }) {
				SteadyChain chain(beam, solution.youngs_modulus);
				chain.lean(degrees * DEGREE, true);
				chain.settle_dead(0.0);
				const glm::dvec2 tip = rest_of(solution.constants, degrees * DEGREE, 0.0f, 0.0f);
				const double error = glm::distance(tip, chain.place(1.0));
				CAPTURE(frequency);
				CAPTURE(degrees);
				CHECK(error < TOLERANCE);
				figures::record_error(
						figures::STEMS, "tip of a leaning stem under its own weight, of its length", TOLERANCE, error);
			}
		}
	}
}

TEST_CASE("stems that lean against a wind in m/s come to rest as chains of 128 links") {
	check_tips(20.0, true, AIR_TOLERANCE_20);
	check_tips(40.0, true, AIR_TOLERANCE_40);
}

TEST_CASE("stems that lean against a wind in newtons come to rest as chains of 128 links") {
	check_tips(20.0, false, FORCE_TOLERANCE_20);
	check_tips(40.0, false, FORCE_TOLERANCE_40);
}

TEST_CASE("air that comes down presses bent stems as it presses a chain of 128 links") {
	constexpr double TOLERANCE = 0.025; // Of the length.
	for (StemBeam beam : stems()) {
		beam.damping_ratio = 0.7f;
		const StemSolution solution = solve_stem(beam);
		const StemConstants &stem = solution.constants;
		const double unit = 1.0 / std::sqrt(static_cast<double>(stem.air_slope)); // A linear slope of 1.
		for (const double degrees : { 0.0, 20.0 }) {
			for (const glm::dvec2 wind :
					{ glm::dvec2(0.4, 0.4), { 0.8, 0.4 }, { 0.8, 0.8 }, { 1.2, 0.6 }, { 0.8, -0.8 } }) {
				SteadyChain chain(beam, solution.youngs_modulus);
				chain.lean(degrees * DEGREE);
				chain.settle_air(unit * wind.x, unit * wind.y);
				const glm::dvec2 tip = rest_of(stem, degrees * DEGREE, 0.0f, static_cast<float>(unit * wind.x),
						static_cast<float>(unit * wind.y));
				const double error = glm::distance(tip, chain.place(1.0));
				CAPTURE(degrees);
				CAPTURE(wind.x);
				CAPTURE(wind.y);
				CHECK(error < TOLERANCE);
				figures::record_error(
						figures::STEMS, "tip of a stem in air that also comes down, of its length", TOLERANCE, error);
			}
		}
	}
}

TEST_CASE("strong air that comes down lays bent stems, and leaves upright ones") {
	for (StemBeam beam : stems()) {
		beam.damping_ratio = 0.3f;
		const StemConstants stem = solve_stem(beam).constants;
		const float unit = 1.0f / std::sqrt(stem.air_slope);
		for (const glm::vec2 wind : { glm::vec2(0.4f, 2.0f), { 0.4f, 4.0f }, { 1.0f, 3.0f } }) {
			CHECK(rest_of(stem, 0.0, 0.0f, unit * wind.x, unit * wind.y).y < 0.7);
		}
		CHECK(rest_of(stem, 0.0, 0.0f, 1e-6f, 3.0f * unit).y > 0.99);
	}
}

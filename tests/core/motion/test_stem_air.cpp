#include "../stem/stems.hpp"
#include "stem_plants.hpp"
#include "swing.hpp"
#include "varied.hpp"

#include "figures.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <vector>

using namespace undergrowth;

namespace {

constexpr double RATIO_TOLERANCE = 0.03;
constexpr double DAMPING_TOLERANCE = 0.003;
constexpr double ENERGY_GROWTH = 1e-6; // Relative, by rounding.

/// A stem without friction of its own, light enough for damping by air.
StemConstants airy_stem(double frequency) {
	StemBeam beam = stem_of(0.5, 0.0, frequency);
	beam.damping_ratio = 0.0f;
	beam.leaf_drag_area = 0.001f;
	return solve_stem(beam).constants;
}

/// Damping ratio of a very small swing about the equilibrium in a wind along x, along it or across.
double damping_in_wind(const StemConstants &stem, float speed, bool is_along, double rate) {
	StemPlants plants(stem, 1, static_cast<float>(1.0 / rate));
	const glm::vec2 wind = { speed, 0.0f };
	plants.apply_wind(0.0f, &wind);
	plants.run(60.0);
	const glm::vec2 calm = plants.place(0);
	plants.set_place(0, calm + (is_along ? glm::vec2(0.004f, 0.0f) : glm::vec2(0.0f, 0.004f)));
	std::vector<double> places;
	for (int i = 0; i < static_cast<int>(3.0 * rate); i++) {
		plants.step();
		const glm::vec2 off = plants.place(0) - calm;
		places.push_back(static_cast<double>(is_along ? off.x : off.y));
	}
	return decay_rate_of(places, 1.0 / rate) / (2.0 * PI * frequency_of(places, 1.0 / rate));
}

} // namespace

TEST_CASE("a wind damps a swing along itself twice as much as one across, by its drag") {
	const StemConstants stem = airy_stem(2.0);
	const StemMode &mode = stem.mode[0];
	const float speed = 1.0f; // Bends the tip by less than 2°.
	REQUIRE(stem.air_slope * speed * speed < 0.03f);
	const double expected = static_cast<double>(mode.air_drag * speed / (2.0f * mode.mass * mode.frequency));
	for (const double rate : { 60.0, 144.0 }) {
		const double across = damping_in_wind(stem, speed, false, rate);
		const double along = damping_in_wind(stem, speed, true, rate);
		CAPTURE(rate);
		CHECK(std::fabs(across - expected) < DAMPING_TOLERANCE);
		CHECK(along / across == doctest::Approx(2.0).epsilon(RATIO_TOLERANCE));
		figures::record(figures::SWINGS, "damping by the air along the wind, over that across", 2.0, along / across, 2);
	}
}

TEST_CASE("a longer plant of a species has the same damping by air") {
	const StemConstants stem = airy_stem(2.0);
	double damping[2];
	for (const int which : { 0, 1 }) {
		StemPlants plants(stem, 1, FRAME_STEP);
		const float length = which == 0 ? stem.length : 2.0f * stem.length;
		float scale;
		stem_scales(stem, &length, 1, &scale);
		plants.set_scale(0, scale);
		const glm::vec2 wind = { 1.0f, 0.0f };
		plants.apply_wind(0.0f, &wind);
		plants.run(60.0);
		const glm::vec2 calm = plants.place(0);
		plants.set_place(0, calm + glm::vec2(which == 0 ? 0.004f : 0.002f, 0.0f));
		std::vector<double> places;
		for (int i = 0; i < 180; i++) {
			plants.step();
			places.push_back(static_cast<double>(plants.place(0).x - calm.x));
		}
		damping[which] = decay_rate_of(places, 1.0 / 60.0);
	}
	CHECK(damping[0] == doctest::Approx(damping[1]).epsilon(0.02));
}

TEST_CASE("energy never increases in still air, for any state") {
	for (const bool has_air : { false, true }) {
		for (const int modes : { 1, 2 }) {
			for (const float step : { 1.0f / 15.0f, FRAME_STEP, 1.0f / 144.0f }) {
				StemBeam beam = stem_of(0.6, 0.3);
				beam.modes = modes;
				beam.leaf_drag_area = 0.002f;
				beam.damping_ratio = 0.01f;
				const StemConstants stem = solve_stem(beam).constants;
				StemPlants plants(stem, 300, step);
				for (int i = 0; i < plants.size(); i++) {
					plants.set_rest(i, { 0.3f * noise(i, 8), 0.3f * noise(i, 9) });
					for (int k = 0; k < modes; k++) {
						const float max = 6.0f * stem.mode[k].frequency;
						plants.set_place(i, { 1.5f * noise(i, 4 * k), 1.5f * noise(i, 4 * k + 1) }, k);
						plants.set_rate(i, { max * noise(i, 4 * k + 2), max * noise(i, 4 * k + 3) }, k);
					}
				}
				plants.use_air(has_air);
				bool grows = false;
				for (int n = 0; n < 300; n++) {
					std::vector<double> before;
					for (int i = 0; i < plants.size(); i++) {
						before.push_back(plants.energy(i));
					}
					plants.step();
					for (int i = 0; i < plants.size(); i++) {
						grows = grows || plants.energy(i) > before[static_cast<std::size_t>(i)] * (1.0 + ENERGY_GROWTH);
					}
				}
				CAPTURE(has_air);
				CAPTURE(modes);
				CAPTURE(step);
				CHECK(!grows);
			}
		}
	}
}

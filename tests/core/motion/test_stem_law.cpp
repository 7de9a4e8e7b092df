#include "stem_plants.hpp"
#include "swing.hpp"

#include "figures.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <vector>

using namespace undergrowth;

namespace {

constexpr double FREQUENCY_TOLERANCE = 0.005; // Relative.
constexpr double DAMPING_TOLERANCE = 0.003;
constexpr double ANGLE_TOLERANCE = 2e-4; // rad.

/// The amplitude's x after each of `steps` steps in calm air.
std::vector<double> ring_down(StemPlants &plants, int steps, int mode) {
	std::vector<double> places;
	for (int i = 0; i < steps; i++) {
		plants.step();
		places.push_back(static_cast<double>(plants.place(0, mode).x));
	}
	return places;
}

} // namespace

TEST_CASE("a stem swings at its declared frequency and damping at 30, 60 and 144 steps a second") {
	for (const int rate : { 30, 60, 144 }) {
		for (const double frequency : { 0.7, 1.6, 5.0 }) {
			const double step = 1.0 / rate;
			StemPlants plants(simple_stem(frequency, 0.06), 1, static_cast<float>(step));
			plants.set_place(0, { 0.3f, 0.0f });
			const std::vector<double> places = ring_down(plants, static_cast<int>(6.0 / frequency * rate), 0);
			CAPTURE(rate);
			CAPTURE(frequency);
			const double swings = frequency_of(places, step) / (frequency * std::sqrt(1.0 - 0.06 * 0.06));
			CHECK(std::fabs(swings - 1.0) < FREQUENCY_TOLERANCE);
			figures::record_error(figures::SWINGS, "declared frequency at 30, 60 and 144 steps a second",
					FREQUENCY_TOLERANCE, swings - 1.0);
			// Crossings of a decaying swing between samples find its peaks within a thousandth.
			const double ratio = decay_rate_of(places, step) / (2.0 * PI * frequency);
			CHECK(std::fabs(ratio - 0.06) < DAMPING_TOLERANCE);
			figures::record_error(
					figures::SWINGS, "declared damping ratio, of critical", DAMPING_TOLERANCE, ratio - 0.06);
		}
	}
}

TEST_CASE("a load in newtons bends the tip to tan θ = its linear slope") {
	for (const bool two : { false, true }) {
		for (const double frequency : { 0.7, 1.5, 7.0, 12.0 }) {
			for (const double load : { 0.1, 0.5, 1.0, 2.5, 12.0, 300.0, 1e4 }) {
				const StemConstants stem = two ? stem_of_two_modes(frequency, 0.1) : simple_stem(frequency, 0.1);
				StemPlants plants(stem, 1, FRAME_STEP);
				plants.apply_wind(static_cast<float>(load) / stem.dead_slope);
				plants.run(30.0 / frequency);
				CAPTURE(frequency);
				CAPTURE(load);
				CHECK(std::fabs(plants.tip_angle(0) - std::atan(load)) < ANGLE_TOLERANCE);
			}
		}
	}
}

TEST_CASE("a wind in m/s bends the tip to sin θ/cos² θ = its linear slope") {
	for (const bool two : { false, true }) {
		for (const double frequency : { 0.7, 1.5, 7.0, 12.0 }) {
			for (const double load : { 0.17, 0.83, 3.33, 16.7, 33.3, 1000.0 }) {
				const StemConstants stem = two ? stem_of_two_modes(frequency, 0.1) : simple_stem(frequency, 0.1);
				StemPlants plants(stem, 1, FRAME_STEP);
				const double scale = 1e-3 * load / static_cast<double>(stem.air_slope); // Wind of 31 m/s.
				plants.set_scale(0, static_cast<float>(scale));
				const glm::vec2 wind = { 0.0f, std::sqrt(1000.0f) };
				plants.apply_wind(0.0f, &wind);
				plants.run(30.0 / frequency);
				const double angle = plants.tip_angle(0);
				CAPTURE(frequency);
				CAPTURE(load);
				CHECK(std::sin(angle) / (std::cos(angle) * std::cos(angle)) == doctest::Approx(load).epsilon(2e-3));
			}
		}
	}
}

TEST_CASE("undamped stems gain no energy under a steady force") {
	constexpr float GAIN = 1.02f; // Of a small swing, by rounding.
	constexpr int SWINGS = 400;
	for (const double frequency : { 0.7, 2.0, 4.0, 10.0 }) {
		for (const float step : { 1.0f / 60.0f, 1.0f / 30.0f }) {
			for (const float slope : { 0.3f, 1.0f, 3.0f }) {
				StemPlants plants(simple_stem(frequency, 0.0), 1, step);
				plants.set_strength(0, slope / plants.constants().dead_slope);
				const float calm = slope / (1.0f + std::sqrt(1.0f + slope * slope));
				plants.set_place(0, { calm + 0.03f, 0.0f });
				const auto furthest_in = [&](int swings) {
					float furthest = 0.0f;
					for (int i = 0; i < static_cast<int>(swings / (frequency * plants.time_step())); i++) {
						plants.step();
						furthest = std::max(furthest, std::abs(plants.place(0).x - calm));
					}
					return furthest;
				};
				const float before = furthest_in(40);
				furthest_in(SWINGS);
				CHECK(furthest_in(40) <= before * GAIN);
			}
		}
	}
}

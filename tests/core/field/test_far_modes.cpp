// Error of distant stems: without a camera near, fields step one mode of stems with two.

#include "../base/sanitized.hpp"
#include "../motion/varied.hpp"
#include "../wind/air_series.hpp"

#include "motion/motion_page.hpp"
#include "stem/stem_beam.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace undergrowth;

namespace {

constexpr float STEP = 1.0f / 60.0f; // s.
constexpr double NEAR = 10.0; // m: beyond this distance fields step one mode of stems without pushes.
constexpr int STEPS = repetitions(3600, 600); // A minute of wind.
/// m: a pixel at that distance, with 1080 rows over 75 degrees.
const double PIXEL = 2.0 * NEAR * std::tan(0.5 * 75.0 * 3.14159265358979 / 180.0) / 1080.0;

FieldWind wind_of(WindKind kind) {
	FieldWind wind;
	wind.wind.kind = kind;
	wind.wind.strength = 1.0f;
	wind.wind.frequency = 0.5f;
	wind.air.speed = 9.0f;
	wind.tiles = std::shared_ptr<const AirTiles>(&shared_tiles(), [](const AirTiles *) {});
	return wind;
}

/// Distances (m) between points on stems of both modes and of one.
struct Apart {
	double max = 0.0;
	double squares = 0.0; ///< m².
	int count = 0;
};

/// For stems of `length` over STEPS of wind.
Apart apart_in(WindKind kind, float length) {
	StemBeam beam;
	beam.length = length;
	beam.modes = 2;
	MotionSpecies species;
	species.law = Law::stem;
	species.stem = solve_stem(beam).constants;
	species.stem.dead_slope = 0.3f; // One newton bends a tip by 17 degrees.
	species.canopy_height = length;
	std::vector<MotionPlant> plants;
	for (int i = 0; i < 40; i++) {
		plants.push_back(varied_plant(i));
		plants.back().length = length;
	}
	MotionPage both(0, species, plants.data(), 40, STEP, true), one = both;
	one.set_modes(1);
	const FieldWind wind = wind_of(kind);
	Apart apart;
	for (int step = 0; step < STEPS; step++) {
		const WindSnapshot now = wind_at_time(wind, (step + 0.5) * static_cast<double>(STEP));
		both.step(now, winds_along(wind));
		one.step(now, winds_along(wind));
		for (int i = 0; i < both.size() && step > 300; i++) {
			for (const float share : { 0.25f, 0.5f, 0.75f, 1.0f }) {
				const auto off = static_cast<double>(glm::distance(both.arm(i, share), one.arm(i, share)));
				apart.max = std::max(apart.max, off);
				apart.squares += off * off;
				apart.count++;
			}
		}
	}
	return apart;
}

} // namespace

TEST_CASE("in wind, stems of one mode differ from stems of two by less than is visible at the switching distance") {
	for (const WindKind kind : { WindKind::air, WindKind::waves, WindKind::bursts }) {
		for (const float length : { 0.3f, 0.6f, 1.0f }) {
			const Apart apart = apart_in(kind, length);
			CHECK(std::sqrt(apart.squares / apart.count) < 0.25 * PIXEL);
			CHECK(apart.max < 1.25 * PIXEL); // Once per minute of 40 plants.
		}
	}
}

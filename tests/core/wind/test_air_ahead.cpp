#include "air_series.hpp"

#include "base/random.hpp"
#include "wind/air.hpp"
#include "wind/air_ahead.hpp"
#include "wind/field_wind.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace undergrowth;

namespace {

constexpr float STEP = 1.0f / 60.0f; // s.
constexpr float STAND = 0.6f; // m.
constexpr float SWING = 0.6f; // s.
constexpr int PLANTS = 203; // Not a whole number of groups.
constexpr double SAMPLED_WITHIN = 1.0 / 256.0; // m/s: half a unit, and half a unit of each weight.

FieldWind fresh_breeze() {
	FieldWind wind;
	wind.wind.kind = WindKind::air;
	wind.air.speed = 9.0f;
	wind.tiles = std::shared_ptr<const AirTiles>(&shared_tiles(), [](const AirTiles *) {});
	return wind;
}

/// Plants with air over them that was sampled ahead.
struct Canopy {
	std::vector<float> x, z, lengths;
	float canopy_height = STAND;
	float swing = SWING;
	AirAhead ahead;
	std::vector<float> ahead_x = std::vector<float>(PLANTS), ahead_z = std::vector<float>(PLANTS);
	std::vector<float> is_x = std::vector<float>(PLANTS), is_z = std::vector<float>(PLANTS);

	Canopy() {
		for (int i = 0; i < PLANTS; i++) {
			x.push_back(10.0f * signed_noise(1, static_cast<uint64_t>(i)));
			z.push_back(10.0f * signed_noise(2, static_cast<uint64_t>(i)));
			lengths.push_back(0.5f + 0.2f * signed_noise(3, static_cast<uint64_t>(i)));
		}
		ahead.make_room(PLANTS);
	}

	/// Looks ahead, uses the samples if they are complete, and also samples the current air directly.
	bool step(const FieldWind &wind, int number, int turn = 0, SimdLevel level = best_simd_level()) {
		const PlantWinds along = winds_along(wind);
		const double moment = (number + 0.5) * static_cast<double>(STEP);
		ahead.prepare(wind, along, moment, STEP, turn,
				{ x.data(), z.data(), lengths.data(), PLANTS, canopy_height, swing }, level);
		const WindSnapshot now = wind_at_time(wind, along, moment);
		const AirMoments moments = moments_over(now.air, canopy_height, along);
		const float *alone = canopy_height > 0.0f ? nullptr : lengths.data();
		sample_air(now, moments, x.data(), z.data(), alone, PLANTS, is_x.data(), is_z.data(), level);
		if (ahead.is_ready()) {
			ahead.interpolate(moments, 0, PLANTS, ahead_x.data(), ahead_z.data(), level);
		}
		return ahead.is_ready();
	}

	/// m/s, the largest over all plants.
	double error() const {
		double max = 0.0;
		for (std::size_t i = 0; i < PLANTS; i++) {
			max = std::max(max, static_cast<double>(std::hypot(ahead_x[i] - is_x[i], ahead_z[i] - is_z[i])));
		}
		return max;
	}
};

} // namespace

TEST_CASE("air sampled ahead matches the current air, except for frequencies without effect on plants") {
	for (const float canopy_height : { STAND, 0.0f }) {
		Canopy canopy;
		canopy.canopy_height = canopy_height;
		const FieldWind wind = fresh_breeze();
		double errors = 0.0, squares = 0.0, sums = 0.0;
		for (int i = 0; i < 600; i++) {
			REQUIRE(canopy.step(wind, i));
			for (std::size_t k = 0; k < PLANTS; k++) {
				const auto is = static_cast<double>(canopy.is_z[k]);
				const double off = static_cast<double>(canopy.ahead_z[k]) - is;
				errors += off * off;
				squares += is * is;
				sums += is;
			}
		}
		const double count = 600.0 * PLANTS;
		const double variance = squares / count - (sums / count) * (sums / count);
		CHECK(std::sqrt(errors / count / variance) < 0.2);
	}
}

TEST_CASE("air is sampled in one of several steps, which differs between pages") {
	const FieldWind wind = fresh_breeze();
	const int stride = AirAhead::stride_in(wind.air, STEP, SWING, STAND);
	REQUIRE(stride > 2);
	for (const int turn : { 0, 1, 2 }) {
		Canopy canopy;
		std::vector<int> exact;
		for (int i = 0; i < 4 * stride; i++) {
			REQUIRE(canopy.step(wind, i, turn));
			if (canopy.error() < SAMPLED_WITHIN) {
				exact.push_back(i);
			}
		}
		REQUIRE(exact.size() == 4);
		for (int i = 0; i < 4; i++) {
			CHECK(exact[static_cast<std::size_t>(i)] == (stride - turn) % stride + i * stride);
		}
	}
}

TEST_CASE("fast plants, strong winds and short waves have more frequent samples") {
	Air air = fresh_breeze().air;
	CHECK(AirAhead::stride_in(air, STEP, 1.0f / 10.5f, STAND) == 1);
	CHECK(AirAhead::stride_in(air, STEP, 0.25f, STAND) == 3);
	air.canopy_wave_amount = 0.0f;
	CHECK(AirAhead::stride_in(air, STEP, 10.0f, STAND) == AirAhead::MAX_STEPS);
	CHECK(AirAhead::stride_in(air, 2.0f * STEP, 10.0f, STAND) == 2);
	CHECK(AirAhead::stride_in(air, 4.0f * STEP, 10.0f, STAND) == 1);
	air.speed = 19.0f;
	CHECK(AirAhead::stride_in(air, STEP, 10.0f, STAND) == 2); // 7.1 m/s.
	CHECK(AirAhead::stride_in(air, STEP, 10.0f, 0.0f) == 1); // 11.5 m/s over open ground.
	air.speed = 9.0f;
	air.canopy_wave_amount = 0.3f;
	air.canopy_height = 0.05f;
	CHECK(AirAhead::stride_in(air, STEP, 10.0f, STAND) == 1);
}

TEST_CASE("nothing is sampled ahead without wind, or if each step samples its own air") {
	Canopy canopy;
	FieldWind wind = fresh_breeze();
	CHECK(canopy.step(wind, 0));
	wind.air.speed = 0.0f;
	CHECK_FALSE(canopy.step(wind, 1));
	wind.air.speed = 9.0f;
	CHECK(canopy.step(wind, 2));
	CHECK(canopy.error() < 0.5);
	wind.wind.kind = WindKind::waves;
	CHECK_FALSE(canopy.step(wind, 3));
	canopy.swing = 0.05f;
	CHECK_FALSE(canopy.step(fresh_breeze(), 4));
}

TEST_CASE("moved or added plants, and a jump in time, have the correct air at once") {
	Canopy canopy;
	const FieldWind wind = fresh_breeze();
	for (int i = 0; i < 10; i++) {
		canopy.step(wind, i);
	}
	for (float &x : canopy.x) {
		x += 40.0f;
	}
	canopy.ahead.forget();
	canopy.step(wind, 10);
	CHECK(canopy.error() < SAMPLED_WITHIN); // For turn 0, a sample is exactly at this step.
	canopy.step(wind, 9000);
	CHECK(canopy.error() < SAMPLED_WITHIN);
}

TEST_CASE("the mean wind over a canopy is that of the step") {
	Canopy canopy;
	FieldWind wind = fresh_breeze();
	wind.air.turbulence = 0.0f;
	for (int i = 0; i < 10; i++) {
		canopy.step(wind, i);
	}
	wind.air.speed = 3.0f;
	wind.wind.direction = 1.0f;
	canopy.step(wind, 10);
	CHECK(canopy.error() < SAMPLED_WITHIN);
}

TEST_CASE("air sampled ahead has the same bits at all levels, for any air") {
	Canopy plain, best;
	FieldWind wind = fresh_breeze();
	for (int i = 0; i < 40; i++) {
		wind.air.speed = i < 20 ? 9.0f : 1e6f;
		wind.air.gustiness = 0.15f;
		plain.step(wind, i, 1, SimdLevel::baseline);
		best.step(wind, i, 1);
		REQUIRE(plain.ahead_x == best.ahead_x);
		REQUIRE(plain.ahead_z == best.ahead_z);
		REQUIRE(std::all_of(best.ahead_x.begin(), best.ahead_x.end(), [](float x) { return std::isfinite(x); }));
	}
}

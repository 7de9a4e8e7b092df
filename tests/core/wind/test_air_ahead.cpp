#include "air_series.hpp"

#include "base/random.hpp"
#include "wind/air.hpp"
#include "wind/air_ahead.hpp"
#include "wind/travelling_wind.hpp"

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
struct Stand {
	std::vector<float> x, z, lengths;
	float canopy_height = STAND;
	float swing = SWING;
	AirAhead ahead;
	std::vector<float> told_x = std::vector<float>(PLANTS), told_z = std::vector<float>(PLANTS);
	std::vector<float> is_x = std::vector<float>(PLANTS), is_z = std::vector<float>(PLANTS);

	Stand() {
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
		ahead.look(wind, along, moment, STEP, turn,
				{ x.data(), z.data(), lengths.data(), PLANTS, canopy_height, swing }, level);
		const TravellingWind now = wind_at_time(wind, along, moment);
		const AirBlow blow = blow_over(now.air, canopy_height, along);
		const float *alone = canopy_height > 0.0f ? nullptr : lengths.data();
		sample_air(now, blow, x.data(), z.data(), alone, PLANTS, is_x.data(), is_z.data(), level);
		if (ahead.is_ready()) {
			ahead.tell(blow, 0, PLANTS, told_x.data(), told_z.data(), level);
		}
		return ahead.is_ready();
	}

	/// m/s, the largest over all plants.
	double error() const {
		double most = 0.0;
		for (std::size_t i = 0; i < PLANTS; i++) {
			most = std::max(most, static_cast<double>(std::hypot(told_x[i] - is_x[i], told_z[i] - is_z[i])));
		}
		return most;
	}
};

} // namespace

TEST_CASE("air sampled ahead matches the current air, except for frequencies without effect on plants") {
	for (const float canopy_height : { STAND, 0.0f }) {
		Stand stand;
		stand.canopy_height = canopy_height;
		const FieldWind wind = fresh_breeze();
		double errors = 0.0, squares = 0.0, sums = 0.0;
		for (int i = 0; i < 600; i++) {
			REQUIRE(stand.step(wind, i));
			for (std::size_t k = 0; k < PLANTS; k++) {
				const auto is = static_cast<double>(stand.is_z[k]);
				const double off = static_cast<double>(stand.told_z[k]) - is;
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
	const int stride = AirAhead::stride_in(wind.air, STEP, SWING);
	REQUIRE(stride > 2);
	for (const int turn : { 0, 1, 2 }) {
		Stand stand;
		std::vector<int> exact;
		for (int i = 0; i < 4 * stride; i++) {
			REQUIRE(stand.step(wind, i, turn));
			if (stand.error() < SAMPLED_WITHIN) {
				exact.push_back(i);
			}
		}
		REQUIRE(exact.size() == 4);
		for (int i = 0; i < 4; i++) {
			CHECK(exact[static_cast<std::size_t>(i)] == (stride - turn) % stride + i * stride);
		}
	}
}

TEST_CASE("fast plants, and those with fast waves over them, have more frequent samples") {
	Air air = fresh_breeze().air;
	CHECK(AirAhead::stride_in(air, STEP, 1.0f / 10.5f) == 1);
	CHECK(AirAhead::stride_in(air, STEP, 0.25f) == 3);
	air.canopy_wave_amount = 0.0f;
	CHECK(AirAhead::stride_in(air, STEP, 10.0f) == AirAhead::MOST_STEPS);
	CHECK(AirAhead::stride_in(air, 2.0f * STEP, 10.0f) == 2);
	CHECK(AirAhead::stride_in(air, 4.0f * STEP, 10.0f) == 1);
	air.canopy_wave_amount = 0.3f;
	air.canopy_height = 0.05f;
	CHECK(AirAhead::stride_in(air, STEP, 10.0f) == 1);
}

TEST_CASE("nothing is sampled ahead without wind, or if each step samples its own air") {
	Stand stand;
	FieldWind wind = fresh_breeze();
	CHECK(stand.step(wind, 0));
	wind.air.speed = 0.0f;
	CHECK_FALSE(stand.step(wind, 1));
	wind.air.speed = 9.0f;
	CHECK(stand.step(wind, 2));
	CHECK(stand.error() < 0.5);
	wind.wind.kind = WindKind::waves;
	CHECK_FALSE(stand.step(wind, 3));
	stand.swing = 0.05f;
	CHECK_FALSE(stand.step(fresh_breeze(), 4));
}

TEST_CASE("moved or added plants, and a jump in time, have the correct air at once") {
	Stand stand;
	const FieldWind wind = fresh_breeze();
	for (int i = 0; i < 10; i++) {
		stand.step(wind, i);
	}
	for (float &x : stand.x) {
		x += 40.0f;
	}
	stand.ahead.forget();
	stand.step(wind, 10);
	CHECK(stand.error() < SAMPLED_WITHIN); // For turn 0, a sample is exactly at this step.
	stand.step(wind, 9000);
	CHECK(stand.error() < SAMPLED_WITHIN);
}

TEST_CASE("the mean wind over a canopy is that of the step") {
	Stand stand;
	FieldWind wind = fresh_breeze();
	wind.air.turbulence = 0.0f;
	for (int i = 0; i < 10; i++) {
		stand.step(wind, i);
	}
	wind.air.speed = 3.0f;
	wind.wind.direction = 1.0f;
	stand.step(wind, 10);
	CHECK(stand.error() < SAMPLED_WITHIN);
}

TEST_CASE("air sampled ahead has the same bits at all levels, for any air") {
	Stand plain, best;
	FieldWind wind = fresh_breeze();
	for (int i = 0; i < 40; i++) {
		wind.air.speed = i < 20 ? 9.0f : 1e6f;
		wind.air.gustiness = 0.15f;
		plain.step(wind, i, 1, SimdLevel::baseline);
		best.step(wind, i, 1);
		REQUIRE(plain.told_x == best.told_x);
		REQUIRE(plain.told_z == best.told_z);
		REQUIRE(std::all_of(best.told_x.begin(), best.told_x.end(), [](float x) { return std::isfinite(x); }));
	}
}

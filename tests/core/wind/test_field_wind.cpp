#include "base/random.hpp"
#include "wind/field_wind.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace undergrowth;

namespace {

constexpr WindKind ALL_KINDS[] = { WindKind::gust, WindKind::constant, WindKind::bursts, WindKind::waves };
constexpr float STRENGTH_TOLERANCE = 2e-4f; // Of a strength of 3 N after 20 cycles of delay, in floats.
constexpr double EDGE = 1e-4; // s; a switching wind may switch this much early or late.
constexpr float HALF_SIDE = 50.0f; // m.
constexpr int PLACES = 1003;

FieldWind wind_of(WindKind kind) {
	FieldWind wind;
	wind.wind.kind = kind;
	wind.wind.strength = 3.0f;
	wind.wind.direction = 2.1f;
	wind.wind.frequency = 0.8f;
	wind.wind.phase = 0.3;
	wind.wind.gust_start = 2.0;
	wind.wind.gust_duration = 1.5f;
	wind.speed = 4.0f;
	return wind;
}

std::vector<float> places(uint64_t which) {
	std::vector<float> all;
	for (int i = 0; i < PLACES; i++) {
		all.push_back(HALF_SIDE * signed_noise(which, static_cast<uint64_t>(i)));
	}
	return all;
}

std::vector<float> strengths(const FieldWind &wind, double time, SimdLevel level) {
	std::vector<float> out(PLACES);
	wind_kernels(level).sample(wind_at_time(wind, time), places(1).data(), places(2).data(), PLACES, out.data());
	return out;
}

bool switches(const Wind &wind, double time) {
	return std::fabs(wind_strength(wind, time - EDGE) - wind_strength(wind, time + EDGE)) > 0.5f * wind.strength;
}

} // namespace

TEST_CASE("a triggered gust reaches all plants, also upwind of its start") {
	for (const float min_delay : { 0.0f, 5.0f, -5.0f }) {
		FieldWind wind = wind_of(WindKind::gust);
		wind.wind.gust_start = 20.0 + static_cast<double>(-min_delay); // Start time for a position that far away.
		wind.min_delay = min_delay;
		std::vector<float> max(PLACES, 0.0f);
		for (double time = 20.0; time < 120.0; time += 0.25) {
			const std::vector<float> felt = strengths(wind, time, best_simd_level());
			for (std::size_t i = 0; i < felt.size(); i++) {
				max[i] = std::max(max[i], felt[i]);
			}
		}
		CHECK(*std::min_element(max.begin(), max.end()) == wind.wind.strength);
		const std::vector<float> before = strengths(wind, 19.9, best_simd_level());
		CHECK(*std::max_element(before.begin(), before.end()) == 0.0f);
	}
}

TEST_CASE("every plant has the delayed wind of its position") {
	for (const WindKind kind : ALL_KINDS) {
		for (const bool triggered : { false, true }) {
			FieldWind wind = wind_of(kind);
			wind.wind.gust_triggered = triggered;
			wind.wind.triggered_strength = 4.0f;
			wind.wind.triggered_duration = 0.9f;
			Wind steady = wind.wind;
			steady.gust_triggered = false;
			steady.strength = kind == WindKind::gust ? 0.0f : steady.strength;
			Wind gusts = wind.wind;
			gusts.kind = WindKind::gust;
			gusts.strength = kind == WindKind::gust || triggered ? gusts.strength : 0.0f;
			for (const double time : { 0.0, 1.7, 2.5, 9.3, 3600.4 }) {
				const std::vector<float> felt = strengths(wind, time, best_simd_level());
				for (int i = 0; i < PLACES; i++) {
					const auto place = static_cast<size_t>(i);
					const double delay = static_cast<double>(wind_delay(wind, places(1)[place], places(2)[place]));
					const double gust_time = time - std::max(delay, 0.0);
					if (!switches(steady, time - delay) && !switches(gusts, gust_time)) {
						const float expected = wind_strength(steady, time - delay) + wind_strength(gusts, gust_time);
						REQUIRE(std::fabs(felt[place] - expected) < STRENGTH_TOLERANCE);
					}
					if (i > 200) {
						break;
					}
				}
			}
		}
	}
}

TEST_CASE("the delay grows along the wind by distance over speed, and not across it") {
	FieldWind wind = wind_of(WindKind::waves);
	const glm::vec3 along = wind_direction(wind.wind);
	CHECK(wind_delay(wind, 8.0f * along.x, 8.0f * along.z) == doctest::Approx(2.0));
	CHECK(std::fabs(wind_delay(wind, -8.0f * along.z, 8.0f * along.x)) < 1e-5f);
	const PlantWinds direction = winds_along(wind);
	CHECK(glm::distance(glm::vec3(direction.x, 0.0f, direction.z), along) < 1e-6f);
}

TEST_CASE("a wind without a speed is the same everywhere") {
	constexpr float INF = std::numeric_limits<float>::infinity();
	for (const float speed : { 0.0f, -3.0f, INF, std::numeric_limits<float>::quiet_NaN() }) {
		FieldWind wind = wind_of(WindKind::waves);
		wind.speed = speed;
		for (const float felt : strengths(wind, 3.3, best_simd_level())) {
			REQUIRE(std::fabs(felt - wind_strength(wind.wind, 3.3)) < STRENGTH_TOLERANCE);
		}
	}
}

TEST_CASE("winds have the same bits at every level") {
	for (const WindKind kind : ALL_KINDS) {
		for (int i = 0; i < 50; i++) {
			REQUIRE(strengths(wind_of(kind), 0.37 * i, SimdLevel::baseline) ==
					strengths(wind_of(kind), 0.37 * i, SimdLevel::avx2));
		}
	}
}

TEST_CASE("a wind with invalid numbers is zero and never invalid") {
	constexpr float NONE = std::numeric_limits<float>::quiet_NaN();
	for (const WindKind kind : ALL_KINDS) {
		for (const float bad : { NONE, -1.0f, std::numeric_limits<float>::infinity(), 1e30f }) {
			FieldWind wind = wind_of(kind);
			wind.wind.strength = bad;
			wind.wind.frequency = bad;
			wind.wind.direction = bad;
			wind.wind.gust_duration = bad;
			wind.wind.gust_start = static_cast<double>(bad);
			wind.wind.phase = static_cast<double>(bad);
			wind.speed = bad;
			for (const float felt : strengths(wind, 5.0, best_simd_level())) {
				REQUIRE(std::isfinite(felt));
			}
		}
	}
}

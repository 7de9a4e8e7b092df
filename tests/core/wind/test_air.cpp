#include "air_series.hpp"

#include "base/random.hpp"
#include "conventions.hpp"
#include "wind/field_wind.hpp"

#include "figures.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <initializer_list>
#include <limits>

using namespace undergrowth;

namespace {

constexpr int PLANTS = 1003;
constexpr float STAND = 0.5f; // m.
constexpr float TURNED = 0.7f; // rad.
constexpr double VELOCITY_TOLERANCE = 2e-3; // m/s, for positions in floats.
constexpr double WAVES_SPEED_TOLERANCE = 0.02;
constexpr double WAVES_SPACING_TOLERANCE = 0.1;

FieldWind breeze() {
	FieldWind wind;
	wind.wind.kind = WindKind::air;
	wind.wind.direction = TURNED;
	wind.air.heading = static_cast<double>(TURNED);
	wind.air.speed = 9.0f;
	wind.tiles = std::shared_ptr<const AirTiles>(&shared_tiles(), [](const AirTiles *) {});
	return wind;
}

std::vector<float> places(uint64_t which) {
	std::vector<float> all;
	for (int i = 0; i < PLANTS; i++) {
		all.push_back(50.0f * signed_noise(which, static_cast<uint64_t>(i)));
	}
	return all;
}

struct Velocities {
	std::vector<float> x = std::vector<float>(PLANTS);
	std::vector<float> z = std::vector<float>(PLANTS);
};

Velocities velocities(const FieldWind &wind, double time, SimdLevel level = best_simd_level()) {
	const WindSnapshot now = wind_at_time(wind, time);
	Velocities out;
	sample_air(now, moments_over(now.air, STAND, winds_along(wind)), places(1).data(), places(2).data(), nullptr,
			PLANTS, out.x.data(), out.z.data(), level);
	return out;
}

/// Waves over the canopy along a line with the wind.
std::vector<float> wave_line(const Air &air, double time) {
	const AirSnapshot now = air_at_time(air, {}, &shared_tiles(), time);
	std::vector<float> x(4000), z(4000), waves(4000);
	for (std::size_t i = 0; i < x.size(); i++) {
		x[i] = 0.02f * static_cast<float>(i) * std::sin(static_cast<float>(air.heading));
		z[i] = 0.02f * static_cast<float>(i) * std::cos(static_cast<float>(air.heading));
	}
	baseline_wind_kernels()->sample_waves(now.waves, 0.0f, x.data(), x.data(), z.data(), 4000, waves.data());
	return waves;
}

std::size_t best_lag(const std::vector<float> &a, const std::vector<float> &b, std::size_t from, std::size_t to) {
	std::size_t best = from;
	for (std::size_t lag = from; lag < to; lag++) {
		best = product(a, b, lag) > product(a, b, best) ? lag : best;
	}
	return best;
}

} // namespace

TEST_CASE("air has the same bits at every level, for any division of plants") {
	for (int i = 0; i < 40; i++) {
		const Velocities whole = velocities(breeze(), 0.37 * i, SimdLevel::baseline);
		const Velocities best = velocities(breeze(), 0.37 * i, SimdLevel::avx2);
		REQUIRE(whole.x == best.x);
		REQUIRE(whole.z == best.z);
		float x = 0.0f, z = 0.0f;
		const WindSnapshot now = wind_at_time(breeze(), 0.37 * i);
		const std::vector<float> xs = places(1), zs = places(2);
		sample_air(now, moments_over(now.air, STAND, winds_along(breeze())), &xs[717], &zs[717], nullptr, 1, &x, &z);
		REQUIRE(x == whole.x[717]);
		REQUIRE(z == whole.z[717]);
	}
}

TEST_CASE("isolated plants have the wind of their own height above open ground") {
	constexpr double PROFILE_TOLERANCE = 1e-4; // Of the speed at 10 m.
	FieldWind wind = breeze();
	std::vector<float> lengths;
	for (int i = 0; i < PLANTS; i++) {
		lengths.push_back(0.02f * static_cast<float>(i));
	}
	const std::vector<float> xs = places(1), zs = places(2);
	for (const bool gusts : { false, true }) {
		wind.air.turbulence = gusts ? -1.0f : 0.0f;
		const WindSnapshot now = wind_at_time(wind, 3.0);
		const AirMoments moments = moments_over(now.air, 0.0f, winds_along(wind));
		Velocities plain, best;
		sample_air(now, moments, xs.data(), zs.data(), lengths.data(), PLANTS, plain.x.data(), plain.z.data(),
				SimdLevel::baseline);
		sample_air(now, moments, xs.data(), zs.data(), lengths.data(), PLANTS, best.x.data(), best.z.data());
		REQUIRE(plain.x == best.x);
		REQUIRE(plain.z == best.z);
		for (std::size_t i = 0; !gusts && i < PLANTS; i++) {
			const double speed = std::hypot(static_cast<double>(plain.x[i]), static_cast<double>(plain.z[i]));
			const double off = speed / static_cast<double>(wind.air.speed) -
					open_ground_speed(static_cast<double>(lengths[i]), static_cast<double>(wind.air.roughness));
			REQUIRE(std::fabs(off) < PROFILE_TOLERANCE);
			figures::record_error(figures::WIND, "logarithmic profile, of the speed at 10 m", PROFILE_TOLERANCE, off);
		}
	}
}

TEST_CASE("the mean over a canopy is the speed at its tops, and gusts are a fraction of it") {
	FieldWind wind = breeze();
	const double top = canopy_top_speed(0.5) * static_cast<double>(wind.air.speed);
	const glm::vec3 along = wind_direction(wind.wind);
	double sum = 0.0, squares = 0.0, cubes = 0.0, side = 0.0;
	std::vector<double> on;
	for (int i = 0; i < 400; i++) {
		const Velocities air = velocities(wind, 1.7 * i);
		for (std::size_t k = 0; k < PLANTS; k += 5) {
			on.push_back(static_cast<double>(air.x[k] * along.x + air.z[k] * along.z));
			side += std::pow(static_cast<double>(air.x[k] * along.z - air.z[k] * along.x), 2.0);
		}
	}
	const auto count = static_cast<double>(on.size());
	for (const double value : on) {
		sum += value / count;
	}
	for (const double value : on) {
		squares += (value - sum) * (value - sum) / count;
		cubes += std::pow(value - sum, 3.0) / count;
	}
	MESSAGE("skewness " << cubes / std::pow(squares, 1.5));
	CHECK(sum == doctest::Approx(top).epsilon(0.05));
	CHECK(std::sqrt(squares) == doctest::Approx(CANOPY_GUSTS * top).epsilon(0.05));
	CHECK(std::sqrt(side / count) == doctest::Approx(SIDE_GUSTS * CANOPY_GUSTS * top).epsilon(0.05));
	CHECK(cubes / std::pow(squares, 1.5) == doctest::Approx(0.55).epsilon(0.2));
}

TEST_CASE("waves over a canopy have the speed and distance of those in a mixing layer") {
	const Air air = breeze().air;
	CHECK(waves_length(air) == doctest::Approx(8.1 * 0.25));
	CHECK(canopy_pattern_speed(air) == doctest::Approx(1.8 * 9.0 * canopy_top_speed(0.5)));
	const std::vector<float> now = wave_line(air, 0.0), later = wave_line(air, 0.2);
	const double speed = 0.02 * static_cast<double>(best_lag(now, later, 1, 60)) / 0.2;
	const double spacing = 0.02 * static_cast<double>(best_lag(now, now, 60, 140));
	figures::record(figures::WIND, "speed of waves over half a metre of grass, fresh breeze", canopy_pattern_speed(air),
			speed, 2, " m/s");
	figures::record(figures::WIND, "their length", waves_length(air), spacing, 2, " m");
	CHECK(std::fabs(speed / canopy_pattern_speed(air) - 1.0) < WAVES_SPEED_TOLERANCE);
	CHECK(std::fabs(spacing / waves_length(air) - 1.0) < WAVES_SPACING_TOLERANCE);
}

namespace {

/// All deviates at a position of the world.
std::vector<float> deviates(const Air &air, double time, const glm::dvec2 &place) {
	const AirSnapshot now = air_at_time(air, { place, { 1.0, 0.0 }, { 0.0, 1.0 } }, &shared_tiles(), time);
	const float origin = 0.0f;
	std::vector<float> all(9);
	float *next = all.data();
	for (const AirMap *map : { &now.open.turbulence, &now.open.eddies, &now.canopy.turbulence, &now.canopy.eddies }) {
		baseline_wind_kernels()->sample_turbulence(*map, &origin, &origin, 1, next, next + 1);
		next += 2;
	}
	baseline_wind_kernels()->sample_waves(now.waves, now.waves_bent, &all[6], &origin, &origin, 1, next);
	return all;
}

} // namespace

TEST_CASE("the wind carries each pattern exactly along its direction, and all over a canopy with one speed") {
	constexpr double DEVIATE_TOLERANCE = 2e-3;
	const Air air = breeze().air;
	const double speeds[] = { turbulence_speed(air), eddies_speed(air), canopy_pattern_speed(air),
		canopy_pattern_speed(air), canopy_pattern_speed(air) };
	const double later = 20.0;
	const glm::dvec2 way = { std::sin(air.heading), std::cos(air.heading) };
	for (int i = 0; i < 100; i++) {
		const glm::dvec2 place = { 40.0 * i, -17.0 * i };
		const std::vector<float> before = deviates(air, 100.0, place);
		for (std::size_t k = 0; k < before.size(); k++) {
			const std::vector<float> now = deviates(air, 100.0 + later, place + later * speeds[k / 2] * way);
			REQUIRE(std::fabs(static_cast<double>(now[k] - before[k])) < DEVIATE_TOLERANCE);
		}
	}
}

TEST_CASE("waves over a canopy do not repeat within a kilometre") {
	constexpr int MANY = 4096;
	constexpr double ERROR = 4.0 / 64.0; // Four standard deviations of a mean product.
	constexpr double MAX_REPEAT = 0.1;
	for (const float height : { 0.1f, 0.5f, 2.0f }) {
		Air air = breeze().air;
		air.heading = 0.0;
		air.canopy_height = height;
		const AirSnapshot now = air_at_time(air, {}, &shared_tiles(), 0.0);
		const auto waves = [&](double right, double on) {
			std::vector<float> x = scattered(1, MANY, 1000.0f), z = scattered(2, MANY, 1000.0f);
			std::vector<float> u(MANY), v(MANY), out(MANY);
			for (std::size_t i = 0; i < MANY; i++) {
				x[i] += static_cast<float>(right);
				z[i] += static_cast<float>(on);
			}
			baseline_wind_kernels()->sample_turbulence(now.canopy.eddies, x.data(), z.data(), MANY, u.data(), v.data());
			baseline_wind_kernels()->sample_waves(
					now.waves, now.waves_bent, u.data(), x.data(), z.data(), MANY, out.data());
			return out;
		};
		const std::vector<float> here = waves(0.0, 0.0);
		const double variance = product(here, here, 0);
		CHECK(variance == doctest::Approx(1.0).epsilon(0.1));
		const double repeat = 16.0 * waves_length(air); // m, of the map, in both directions.
		double worst = 0.0;
		const int last = std::min(static_cast<int>(1000.0 / repeat), 40); // All later ones are like the fortieth.
		for (int i = 0; i <= last; i++) {
			for (int j = i == 0 ? 1 : -3; j <= 3; j++) {
				worst = std::max(worst, product(here, waves(repeat * j, repeat * i), 0) / variance);
				worst = std::max(worst, product(here, waves(repeat * i, repeat * j), 0) / variance);
			}
		}
		MESSAGE(height << " m: " << worst);
		CHECK(worst < MAX_REPEAT + ERROR);
		if (height == 0.5f) {
			figures::record_error(figures::WIND, "likeness of waves within a kilometre", MAX_REPEAT, worst);
		}
	}
}

TEST_CASE("patterns at the origin continue through any change of the air") {
	FieldWind wind = breeze();
	const std::vector<float> before = deviates(wind.air, 77.0, { 0.0, 0.0 });
	const AirMap waves = wind_at_time(wind, 77.0).air.waves;
	REQUIRE(waves.cells != nullptr);
	Air wanted = wind.air;
	for (int change = 0; change < 5; change++) {
		wanted.speed = change == 0 ? 3.0f : wanted.speed;
		wanted.heading = change == 1 ? 4.0 : wanted.heading;
		wanted.canopy_height = change == 2 ? 1.7f : wanted.canopy_height;
		wanted.roughness = change == 3 ? 0.2f : wanted.roughness;
		wanted.gustiness = change == 4 ? 0.0f : wanted.gustiness;
		change_air(wind.air, wanted, 77.0);
		const std::vector<float> now = deviates(wind.air, 77.0, { 0.0, 0.0 });
		for (std::size_t k = 0; k < 8; k++) {
			REQUIRE(now[k] == before[k]);
		}
		if (change < 2) { // Eddies displace waves by other parts of their length over another canopy.
			REQUIRE(now[8] == before[8]);
		}
		const AirMap same_waves = wind_at_time(wind, 77.0).air.waves;
		CHECK(same_waves.s == doctest::Approx(waves.s));
		CHECK(same_waves.n == doctest::Approx(waves.n));
		CHECK(wind.air.speed == wanted.speed);
	}
}

TEST_CASE("a wind that turned is that of one that had its direction from the start") {
	const Air straight = breeze().air;
	Air turned = straight;
	for (int i = 1; i <= 20; i++) {
		Air wanted = turned;
		wanted.heading = i < 20 ? 0.3 * i : straight.heading;
		change_air(turned, wanted, 3.25 * i);
	}
	for (const double time : { 70.0, 4000.0 }) {
		for (const glm::dvec2 &place : { glm::dvec2(0.0, 0.0), glm::dvec2(812.5, -300.25) }) {
			const std::vector<float> one = deviates(turned, time, place), other = deviates(straight, time, place);
			for (std::size_t k = 0; k < one.size(); k++) {
				REQUIRE(std::fabs(static_cast<double>(one[k] - other[k])) < 1e-3); // Sums of distances round.
			}
		}
	}
}

TEST_CASE("air is independent of the axes of its positions") {
	FieldWind world = breeze();
	const glm::dvec2 origin = { 1234.5, -87.0 };
	const double turn = 0.6, scale = 2.0;
	FieldWind field = breeze();
	field.axes.origin = origin;
	field.axes.x = scale * glm::dvec2(std::cos(turn), -std::sin(turn));
	field.axes.z = scale * glm::dvec2(std::sin(turn), std::cos(turn));
	world.axes.origin = origin + 3.0 * field.axes.x + 5.0 * field.axes.z;
	const float x = 3.0f, z = 5.0f, none = 0.0f, height = 0.4f;
	glm::vec2 found = {}, there = {};
	const WindSnapshot in_field = wind_at_time(field, 100.0), in_world = wind_at_time(world, 100.0);
	const AirMoments moments = moments_over(in_world.air, 0.0f, winds_along(world));
	sample_air(in_field, moments, &x, &z, &height, 1, &found.x, &found.y);
	sample_air(in_world, moments, &none, &none, &height, 1, &there.x, &there.y);
	CHECK(static_cast<double>(glm::distance(found, there)) < VELOCITY_TOLERANCE);
	const glm::vec3 place = { static_cast<float>(world.axes.origin.x), height,
		static_cast<float>(world.axes.origin.y) };
	const glm::vec3 expected = air_velocity(world.air, world.tiles.get(), 100.0, place);
	CHECK(static_cast<double>(glm::distance(expected, glm::vec3(there.x, 0.0f, there.y))) < VELOCITY_TOLERANCE);
}

TEST_CASE("still air samples nothing and has no wind") {
	FieldWind wind = breeze();
	wind.air.speed = 0.0f;
	const WindSnapshot now = wind_at_time(wind, 10.0);
	CHECK(now.air.open.turbulence.cells == nullptr);
	CHECK(now.air.waves.cells == nullptr);
	const Velocities still = velocities(wind, 10.0);
	CHECK(still.x == std::vector<float>(PLANTS));
	CHECK(still.z == std::vector<float>(PLANTS));
	wind = breeze();
	wind.air.turbulence = 0.0f;
	CHECK(wind_at_time(wind, 10.0).air.open.turbulence.cells == nullptr);
	const Velocities smooth = velocities(wind, 10.0);
	CHECK(std::all_of(smooth.x.begin(), smooth.x.end(), [&](float x) { return x == smooth.x[0] && x > 0.5f; }));
}

TEST_CASE("a triggered gust adds metres per second to the air") {
	FieldWind wind = breeze();
	wind.speed = 0.0f;
	const Velocities before = velocities(wind, 2.0);
	wind.wind.gust_triggered = true;
	wind.wind.gust_start = 1.5;
	wind.wind.triggered_duration = 1.0f;
	wind.wind.triggered_strength = 4.0f;
	const Velocities blown = velocities(wind, 2.0);
	const glm::vec3 along = wind_direction(wind.wind);
	for (std::size_t i = 0; i < PLANTS; i++) {
		REQUIRE(blown.x[i] - before.x[i] == doctest::Approx(4.0f * along.x).epsilon(1e-4));
		REQUIRE(blown.z[i] - before.z[i] == doctest::Approx(4.0f * along.z).epsilon(1e-4));
	}
}

TEST_CASE("air with invalid or out-of-range numbers is finite") {
	constexpr float NONE = std::numeric_limits<float>::quiet_NaN();
	constexpr float INF = std::numeric_limits<float>::infinity();
	for (const float bad : { NONE, INF, -INF, -1.0f, 1e30f, 1e-30f }) {
		for (int which = 0; which < 8; which++) {
			FieldWind wind = breeze();
			Air &air = wind.air;
			float *numbers[] = { &air.speed, &air.turbulence, &air.gustiness, &air.roughness, &air.canopy_height,
				&air.canopy_wave_amount };
			if (which < 6) {
				*numbers[which] = bad;
			} else {
				air.heading = which == 6 ? static_cast<double>(bad) : air.heading;
				wind.axes.origin.x = which == 7 ? static_cast<double>(bad) : 0.0;
			}
			const double times[] = { 3.0, static_cast<double>(bad) };
			for (const double time : times) {
				const Velocities felt = velocities(wind, time);
				for (std::size_t i = 0; i < PLANTS; i++) {
					REQUIRE(std::isfinite(felt.x[i]));
					REQUIRE(std::isfinite(felt.z[i]));
				}
			}
		}
	}
}

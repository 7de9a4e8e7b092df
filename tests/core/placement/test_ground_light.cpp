#include "placement/ground_light.hpp"

#include "conventions.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace undergrowth;

namespace {

constexpr double LATITUDE = 50.0 * PI / 180.0;

/// A square grid around the origin, 1 m apart.
template <class Height> HeightGrid grid_of(int side, Height height) {
	HeightGrid grid;
	grid.columns = grid.rows = side;
	grid.low = glm::vec2(-0.5f * static_cast<float>(side - 1));
	grid.heights.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
	for (std::size_t i = 0; i < grid.size(); i++) {
		const glm::vec2 point = grid.point(i);
		grid.heights[i] = static_cast<float>(height(static_cast<double>(point.x), static_cast<double>(point.y)));
	}
	return grid;
}

/// Light in the middle of a plane that descends towards +z by `angle` (rad).
double light_on_slope(double angle, double latitude) {
	const HeightGrid grid = grid_of(41, [&](double, double z) { return -std::tan(angle) * z; });
	return static_cast<double>(find_light(grid, latitude).at({ 0.0f, 0.0f }));
}

/// The same, by the closed form of a day of the equinox: the sun moves in a plane.
double expected_on_slope(double angle, double latitude) {
	const double direct = std::max(std::cos(latitude - angle) / std::cos(latitude), 0.0);
	double open = 0.0;
	for (int i = 0; i < HORIZON_DIRECTIONS; i++) {
		const double up = std::max(-std::tan(angle) * std::sin(2.0 * PI * i / HORIZON_DIRECTIONS), 0.0);
		open += 1.0 / (1.0 + up * up) / HORIZON_DIRECTIONS;
	}
	return 0.5 * (0.7 * direct + 0.3 * open);
}

} // namespace

TEST_CASE("level open ground has half of the light") {
	const HabitatRaster light = find_light(grid_of(21, [](double, double) { return 3.0; }), LATITUDE);
	CHECK(std::all_of(
			light.values.begin(), light.values.end(), [](float value) { return std::abs(value - 0.5f) < 1.0e-6f; }));
}

TEST_CASE("slopes towards the sun have more light, by the closed form of the equinox") {
	for (const double degrees : { 10.0, 25.0, 40.0 }) {
		const double angle = degrees * PI / 180.0;
		CHECK(light_on_slope(angle, LATITUDE) == doctest::Approx(expected_on_slope(angle, LATITUDE)));
		CHECK(light_on_slope(angle, LATITUDE) > 0.5);
		CHECK(light_on_slope(-angle, LATITUDE) == doctest::Approx(light_on_slope(angle, -LATITUDE)));
		CHECK(light_on_slope(-angle, LATITUDE) < 0.45);
	}
	CHECK(light_on_slope(0.3, 0.0) < 0.5);
	CHECK(std::isfinite(light_on_slope(0.3, 0.5 * PI)));
}

TEST_CASE("a slope to the north has light as long as the sun is above it") {
	const double angle = 20.0 * PI / 180.0;
	const HeightGrid grid = grid_of(41, [&](double, double z) { return std::tan(angle) * z; });
	const double direct = std::cos(LATITUDE + angle) / std::cos(LATITUDE);
	double open = 0.0;
	for (int i = 0; i < HORIZON_DIRECTIONS; i++) {
		const double up = std::max(std::tan(angle) * std::sin(2.0 * PI * i / HORIZON_DIRECTIONS), 0.0);
		open += 1.0 / (1.0 + up * up) / HORIZON_DIRECTIONS;
	}
	CHECK(find_light(grid, LATITUDE).at({ 0.0f, 0.0f }) ==
			doctest::Approx(0.5 * (0.7 * direct + 0.3 * open)).epsilon(0.03));
}

TEST_CASE("the horizon of a round wall has one height, and takes the sun below it") {
	constexpr double RADIUS = 30.0;
	for (const double degrees : { 20.0, 60.0 }) {
		const double tangent = std::tan(degrees * PI / 180.0);
		const HeightGrid grid = grid_of(
				101, [&](double x, double z) { return x * x + z * z < RADIUS * RADIUS ? 0.0 : RADIUS * tangent; });
		const Horizon horizon = find_horizon(grid, 50, 50);
		for (const double found : horizon) {
			CHECK(found < 1.01 * tangent);
			CHECK(found > 0.85 * tangent);
		}
		const double light = static_cast<double>(find_light(grid, LATITUDE).at({ 0.0f, 0.0f }));
		const double sky = std::cos(degrees * PI / 180.0);
		if (degrees > 50.0) { // The sun is at 40° at most.
			CHECK(light == doctest::Approx(0.5 * 0.3 * sky * sky).epsilon(0.3));
		} else { // It is below the wall at the start and the end of the day: sin(hour) cos(latitude) < sin(20°).
			const double hour = std::asin(std::sin(degrees * PI / 180.0) / std::cos(LATITUDE));
			CHECK(light == doctest::Approx(0.5 * (0.7 * std::cos(hour) + 0.3 * sky * sky)).epsilon(0.06));
		}
	}
}

TEST_CASE("points without ground hide nothing") {
	HeightGrid grid = grid_of(21, [](double, double) { return 0.0; });
	grid.heights[grid.index(12, 10)] = std::numeric_limits<float>::quiet_NaN();
	const HabitatRaster light = find_light(grid, LATITUDE);
	CHECK(light.values[grid.index(10, 10)] == doctest::Approx(0.5));
	CHECK(light.values[grid.index(12, 10)] == doctest::Approx(0.5));
}

TEST_CASE("the sun is highest at noon, towards the equator") {
	const std::vector<glm::dvec3> path = sun_path(LATITUDE);
	CHECK(path.front().x > 0.9);
	CHECK(path.back().x < -0.9);
	const glm::dvec3 noon = path[path.size() / 2];
	CHECK(noon.y == doctest::Approx(std::cos(LATITUDE)).epsilon(0.01));
	CHECK(noon.z > 0.7);
	CHECK(sun_path(-LATITUDE)[path.size() / 2].z < -0.7);
}

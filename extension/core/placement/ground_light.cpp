#include "placement/ground_light.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr int SUN_POSITIONS = 24;
constexpr double SUN_SHARE = 0.7;
/// Light of level open ground.
constexpr double OPEN_LIGHT = 0.5;
/// Steps between points along a ray: 1 each up to DENSE_STEPS, then longer by this factor each.
constexpr int DENSE_STEPS = 6;
constexpr double STEP_GROWTH = 1.12;
/// Close to a pole the sun at the equinox only touches the horizon.
constexpr double MAX_LATITUDE = 85.0 * PI / 180.0;

/// Height between the points of a grid; NaN beside it.
double height_at(const HeightGrid &grid, double column, double row) {
	const double low_column = std::floor(column);
	const double low_row = std::floor(row);
	if (!(low_column >= 0.0 && low_row >= 0.0 && low_column + 1.0 < grid.columns && low_row + 1.0 < grid.rows)) {
		return NAN;
	}
	const std::size_t corner = grid.index(static_cast<int>(low_column), static_cast<int>(low_row));
	const auto width = static_cast<std::size_t>(grid.columns);
	const double across = column - low_column;
	const double near = grid.heights[corner] * (1.0 - across) + grid.heights[corner + 1] * across;
	const double far = grid.heights[corner + width] * (1.0 - across) + grid.heights[corner + width + 1] * across;
	return near + (far - near) * (row - low_row);
}

glm::dvec2 direction(int number) {
	const SineAndCosine turn = portable_sine_and_cosine(number * (2.0 * PI / HORIZON_DIRECTIONS));
	return { turn.cosine, turn.sine };
}

/// The directions of horizons, and the path of the sun among them.
class Sky {
public:
	explicit Sky(double latitude) : suns(sun_path(latitude)) {
		for (const glm::dvec3 &sun : suns) {
			const double turn = portable_atan2(sun.z, sun.x) / (2.0 * PI) * HORIZON_DIRECTIONS;
			turns.push_back(turn < 0.0 ? turn + HORIZON_DIRECTIONS : turn);
			on_level += sun.y;
		}
	}

	/// Light of a point with this horizon and normal (unit vector).
	double light(const Horizon &horizon, const glm::dvec3 &normal) const {
		double direct = 0.0;
		for (std::size_t i = 0; i < suns.size(); i++) {
			const glm::dvec3 &sun = suns[i];
			const double facing = sun.x * normal.x + sun.y * normal.y + sun.z * normal.z;
			const double level = std::sqrt(sun.x * sun.x + sun.z * sun.z);
			direct += facing > 0.0 && sun.y > horizon_at(horizon, turns[i]) * level ? facing : 0.0;
		}
		double open = 0.0;
		for (const double tangent : horizon) { // cos² of the horizon's angle.
			open += 1.0 / (1.0 + tangent * tangent);
		}
		const double all = SUN_SHARE * direct / on_level + (1.0 - SUN_SHARE) * open / HORIZON_DIRECTIONS;
		return std::clamp(OPEN_LIGHT * all, 0.0, 1.0);
	}

private:
	std::vector<glm::dvec3> suns;
	std::vector<double> turns; ///< Of the suns, in directions of horizons.
	double on_level = 0.0; ///< Of all suns, on level ground.

	static double horizon_at(const Horizon &horizon, double turn) {
		const auto before = static_cast<std::size_t>(turn) % horizon.size();
		const double share = turn - std::floor(turn);
		return horizon[before] * (1.0 - share) + horizon[(before + 1) % horizon.size()] * share;
	}
};

} // namespace

Horizon find_horizon(const HeightGrid &grid, int column, int row) {
	const double own = grid.heights[grid.index(column, row)];
	Horizon horizon{};
	for (int i = 0; i < HORIZON_DIRECTIONS; i++) {
		const glm::dvec2 towards = direction(i);
		double apart = 0.0; // Steps.
		for (int k = 1;; k++) {
			apart = k <= DENSE_STEPS ? k : apart * STEP_GROWTH;
			const double at_column = column + towards.x * apart;
			const double at_row = row + towards.y * apart;
			if (!(at_column >= 0.0 && at_row >= 0.0 && at_column <= grid.columns && at_row <= grid.rows)) {
				break;
			}
			const double rise = height_at(grid, at_column, at_row) - own; // NaN is no hindrance.
			const double tangent = rise / (apart * static_cast<double>(grid.step));
			horizon[static_cast<std::size_t>(i)] =
					tangent > horizon[static_cast<std::size_t>(i)] ? tangent : horizon[static_cast<std::size_t>(i)];
		}
	}
	return horizon;
}

std::vector<glm::dvec3> sun_path(double latitude) {
	const SineAndCosine tilt = portable_sine_and_cosine(std::clamp(latitude, -MAX_LATITUDE, MAX_LATITUDE));
	std::vector<glm::dvec3> path;
	for (int i = 0; i < SUN_POSITIONS; i++) {
		const SineAndCosine hour = portable_sine_and_cosine(PI * (i + 0.5) / SUN_POSITIONS);
		path.emplace_back(hour.cosine, hour.sine * tilt.cosine, hour.sine * tilt.sine);
	}
	return path;
}

HabitatRaster find_light(const HeightGrid &grid, double latitude) {
	const Sky sky(latitude);
	HabitatRaster raster = grid.raster(static_cast<float>(OPEN_LIGHT));
	for (int row = 0; row < grid.rows; row++) {
		for (int column = 0; column < grid.columns; column++) {
			const std::size_t here = grid.index(column, row);
			if (!std::isfinite(grid.heights[here])) {
				continue;
			}
			const glm::dvec2 slope = grid.gradient(column, row);
			const double length = std::sqrt(1.0 + slope.x * slope.x + slope.y * slope.y);
			const glm::dvec3 normal = { -slope.x / length, 1.0 / length, -slope.y / length };
			raster.values[here] = static_cast<float>(sky.light(find_horizon(grid, column, row), normal));
		}
	}
	return raster;
}

} // namespace undergrowth

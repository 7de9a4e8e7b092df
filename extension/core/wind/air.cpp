#include "wind/air.hpp"

#include "base/portable_math.hpp"
#include "wind/air_profile.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr double CARRIED_AT = 1.0; // m above the ground: the reference height of the turbulence map,
constexpr double EDDIES_CARRIED_AT = 10.0; // and of the map of eddies.
constexpr double PATTERNS_OVER_TOP = 1.8;
constexpr double WAVES_PER_SHEAR = 8.1; // Wave length relative to the shear length,
constexpr double SHEAR_LENGTH = 0.5; // which is relative to the canopy's height.
constexpr double WAVES_BENT = 0.4; // m, displacement of waves per standard deviation of the eddies,
constexpr double WAVES_BENT_SHARE = 0.25; // and more for longer waves.
constexpr float FASTEST = 150.0f; // m/s.
constexpr float MAX_GUSTS = 10.0f;
constexpr float MAX_SKEW = 0.5f;

float safe(float value, float max) {
	return std::isfinite(value) ? std::clamp(value, 0.0f, max) : 0.0f;
}

/// Unit vectors along the wind and across it.
struct Heading {
	explicit Heading(double angle) : along(portable_sin(angle), portable_cos(angle)), across(along.y, -along.x) {}

	glm::dvec2 along, across;

	glm::dvec2 turned(const glm::dvec2 &place) const { return { glm::dot(along, place), glm::dot(across, place) }; }
};

/// How a line along the wind crosses the rows of a periodic map: with a slope, and with a sine of `sway` metres. So a
/// position meets other rows each time that the map repeats, although the map travels exactly along the wind.
struct Rows {
	double slope = 0.0;
	double sway = 0.0; ///< m.
	double period = 1.0; ///< m.
};

/// Chosen so that the correlation of a position with itself is below 0.11 at all repetitions within 42 km,
constexpr Rows TURBULENCE_ROWS = { 0.0416, 80.0, 3909.5 };
/// and below 0.03 within 70 km.
constexpr Rows EDDY_ROWS = { 0.0555 };

double way_at(double way, double speed, double since, double time) {
	const double gone = speed * (time - since);
	return std::isfinite(gone) ? way + gone : way;
}

/// `value` modulo `size`, the size of a map.
double within(double value, double size) {
	const double rest = value - size * std::floor(value / size);
	return std::isfinite(rest) && rest < size ? rest : 0.0;
}

/// Size of a map and of its texels, in texels and metres.
struct MapSize {
	int width, height;
	glm::dvec2 texel;
};

/// A map that was carried by `way` metres, for positions in `axes`.
AirMap map_at(const std::vector<uint64_t> &cells, const MapSize &size, const Rows &rows, const Heading &heading,
		double way, const AirAxes &axes) {
	const glm::dvec2 parts = static_cast<double>(AirMap::PARTS) / size.texel;
	const auto in_map = [&](const glm::dvec2 &place) {
		return parts * glm::dvec2(place.x, place.y + rows.slope * place.x);
	};
	const glm::dvec2 place = heading.turned(axes.origin) - glm::dvec2(way, 0.0);
	const glm::dvec2 start = in_map(place);
	const glm::dvec2 by_x = in_map(heading.turned(axes.x));
	const glm::dvec2 by_z = in_map(heading.turned(axes.z));
	AirMap map;
	map.cells = cells.data();
	map.s = static_cast<float>(within(start.x, size.width * static_cast<double>(AirMap::PARTS)));
	map.n = static_cast<float>(within(start.y, size.height * static_cast<double>(AirMap::PARTS)));
	map.s_x = static_cast<float>(by_x.x);
	map.n_x = static_cast<float>(by_x.y);
	map.s_z = static_cast<float>(by_z.x);
	map.n_z = static_cast<float>(by_z.y);
	map.sway = static_cast<float>(parts.y * rows.sway);
	map.turn = static_cast<float>(within(place.x, rows.period) / rows.period);
	map.turn_x = static_cast<float>(heading.turned(axes.x).x / rows.period);
	map.turn_z = static_cast<float>(heading.turned(axes.z).x / rows.period);
	return map;
}

AirPatterns patterns_at(
		const AirTiles &tiles, const Heading &heading, double turbulence_way, double eddies_way, const AirAxes &axes) {
	constexpr int WIDTH = AirTiles::WIDTH;
	constexpr int HEIGHT = AirTiles::HEIGHT;
	return { map_at(tiles.turbulence, { WIDTH, HEIGHT, { AirTiles::LENGTH_STEP, AirTiles::SIDE_STEP } },
					 TURBULENCE_ROWS, heading, turbulence_way, axes),
		map_at(tiles.eddies, { WIDTH, HEIGHT, { AirTiles::EDDY_LENGTH_STEP, AirTiles::EDDY_SIDE_STEP } }, EDDY_ROWS,
				heading, eddies_way, axes) };
}

glm::dvec2 wave_texel(const Air &air) {
	return waves_length(air) / glm::dvec2(AirTiles::WAVE_TEXELS, AirTiles::WAVE_SIDE_TEXELS);
}

/// Turbulence relative to that of open ground with its roughness.
float gusts_of(const Air &air) {
	if (!(air.turbulence >= 0.0f)) {
		return 1.0f;
	}
	const double usual = open_ground_gusts(REFERENCE_HEIGHT, static_cast<double>(air.roughness));
	return safe(static_cast<float>(static_cast<double>(air.turbulence) / usual), MAX_GUSTS);
}

} // namespace

double turbulence_speed(const Air &air) {
	const auto speed = static_cast<double>(safe(air.speed, FASTEST));
	return speed * open_ground_speed(CARRIED_AT, static_cast<double>(air.roughness));
}

double eddies_speed(const Air &air) {
	const auto speed = static_cast<double>(safe(air.speed, FASTEST));
	return speed * open_ground_speed(EDDIES_CARRIED_AT, static_cast<double>(air.roughness));
}

double canopy_pattern_speed(const Air &air) {
	const auto speed = static_cast<double>(safe(air.speed, FASTEST));
	return air.canopy_height > 0.0f
			? PATTERNS_OVER_TOP * speed * canopy_top_speed(static_cast<double>(air.canopy_height))
			: turbulence_speed(air);
}

double waves_length(const Air &air) {
	constexpr float SHORTEST = 1e-3f; // m, of a canopy.
	return WAVES_PER_SHEAR * SHEAR_LENGTH * static_cast<double>(std::max(safe(air.canopy_height, 1e3f), SHORTEST));
}

void change_air(Air &air, const Air &wanted, double time) {
	const Air before = air;
	const double stretch = waves_length(wanted) / waves_length(before);
	const auto way = [&](double start, double speed) { return way_at(start, speed, before.since, time); };
	air = wanted;
	air.since = time;
	air.turbulence_way = way(before.turbulence_way, turbulence_speed(before));
	air.eddies_way = way(before.eddies_way, eddies_speed(before));
	air.canopy_way = way(before.canopy_way, canopy_pattern_speed(before));
	air.waves_way = stretch * way(before.waves_way, canopy_pattern_speed(before));
}

AirSnapshot air_at_time(const Air &air, const AirAxes &axes, const AirTiles *tiles, double time) {
	AirSnapshot now;
	now.speed = safe(air.speed, FASTEST);
	now.gusts = gusts_of(air);
	now.roughness = air.roughness;
	now.skew = safe(air.gustiness, MAX_SKEW);
	now.canopy_wave_amount = air.canopy_height > 0.0f ? safe(air.canopy_wave_amount, 1.0f) : 0.0f;
	if (!tiles || now.speed <= 0.0f || now.gusts <= 0.0f) {
		now.gusts = 0.0f;
		return now;
	}
	const Heading heading(std::isfinite(air.heading) ? air.heading : 0.0);
	const auto way = [&](double start, double speed) { return way_at(start, speed, air.since, time); };
	const double over_canopy = way(air.canopy_way, canopy_pattern_speed(air));
	now.open = patterns_at(*tiles, heading, way(air.turbulence_way, turbulence_speed(air)),
			way(air.eddies_way, eddies_speed(air)), axes);
	now.canopy = patterns_at(*tiles, heading, over_canopy, over_canopy, axes);
	if (now.canopy_wave_amount > 0.0f) {
		const glm::dvec2 texel = wave_texel(air);
		now.waves = map_at(tiles->waves, { AirTiles::WAVES_WIDTH, AirTiles::WAVES_HEIGHT, texel }, {}, heading,
				way(air.waves_way, canopy_pattern_speed(air)), axes);
		const double bent = WAVES_BENT + WAVES_BENT_SHARE * waves_length(air);
		now.waves_bent = static_cast<float>(bent * static_cast<double>(AirMap::PARTS) / texel.x);
	}
	return now;
}

glm::vec3 air_velocity(const Air &air, const AirTiles *tiles, double time, const glm::vec3 &place) {
	WindSnapshot now = {};
	now.is_air = true;
	AirAxes axes;
	axes.origin = { static_cast<double>(place.x), static_cast<double>(place.z) };
	now.air = air_at_time(air, axes, tiles, time);
	const Heading heading(std::isfinite(air.heading) ? air.heading : 0.0);
	const glm::vec2 along = heading.along;
	const glm::vec2 across = heading.across;
	const float origin = 0.0f;
	glm::vec3 velocity = { 0.0f, 0.0f, 0.0f };
	const AirMoments moments = moments_over(now.air, 0.0f, { nullptr, along.x, along.y, across.x, across.y });
	sample_air(now, moments, &origin, &origin, &place.y, 1, &velocity.x, &velocity.z, SimdLevel::baseline);
	return velocity;
}

} // namespace undergrowth

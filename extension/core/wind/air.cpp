#include "wind/air.hpp"

#include "base/portable_math.hpp"
#include "wind/air_profile.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr double CARRIED_AT = 1.0; // m above the ground: the reference height of the turbulence maps.
// Across, relative to the motion along the wind: positions meet other rows of the maps each time.
constexpr double DRIFT = 0.0683;
constexpr double WAVES_OVER_TOP = 1.8;
constexpr double WAVES_PER_SHEAR = 8.1; // Wave length relative to the shear length,
constexpr double SHEAR_LENGTH = 0.5; // which is relative to the canopy's height.
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

glm::dvec2 way_at(const glm::dvec2 &way, double speed, double since, double time) {
	const double gone = speed * (time - since);
	return std::isfinite(gone) ? way + gone * glm::dvec2(1.0, DRIFT) : way;
}

/// `value` modulo `size`, the size of a map.
double within(double value, double size) {
	const double rest = value - size * std::floor(value / size);
	return std::isfinite(rest) && rest < size ? rest : 0.0;
}

/// A map with texels `texel` metres apart and the offset `way`, for positions in `axes`.
AirMap map_at(const std::vector<uint64_t> &cells, const glm::dvec2 &texel, const glm::dvec2 &size,
		const Heading &heading, const glm::dvec2 &way, const AirAxes &axes) {
	const glm::dvec2 part = texel / static_cast<double>(AirMap::PARTS);
	const glm::dvec2 start = (heading.turned(axes.origin) - way) / part;
	const glm::dvec2 by_x = heading.turned(axes.x) / part;
	const glm::dvec2 by_z = heading.turned(axes.z) / part;
	AirMap map;
	map.cells = cells.data();
	map.s = static_cast<float>(within(start.x, size.x * static_cast<double>(AirMap::PARTS)));
	map.n = static_cast<float>(within(start.y, size.y * static_cast<double>(AirMap::PARTS)));
	map.s_x = static_cast<float>(by_x.x);
	map.n_x = static_cast<float>(by_x.y);
	map.s_z = static_cast<float>(by_z.x);
	map.n_z = static_cast<float>(by_z.y);
	return map;
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

double waves_speed(const Air &air) {
	const auto speed = static_cast<double>(safe(air.speed, FASTEST));
	return WAVES_OVER_TOP * speed * canopy_top_speed(static_cast<double>(air.canopy_height));
}

double waves_length(const Air &air) {
	constexpr float SHORTEST = 1e-3f; // m, of a canopy.
	return WAVES_PER_SHEAR * SHEAR_LENGTH * static_cast<double>(std::max(safe(air.canopy_height, 1e3f), SHORTEST));
}

glm::dvec2 turbulence_way(const Air &air, double time) {
	return way_at(air.turbulence_way, turbulence_speed(air), air.since, time);
}

glm::dvec2 waves_way(const Air &air, double time) {
	return way_at(air.waves_way, waves_speed(air), air.since, time);
}

void change_air(Air &air, const Air &wanted, double time, const glm::dvec2 &pivot) {
	const glm::dvec2 before = Heading(air.heading).turned(pivot);
	const glm::dvec2 now = Heading(wanted.heading).turned(pivot);
	const double stretch = waves_length(wanted) / waves_length(air);
	const glm::dvec2 turbulence = now - (before - turbulence_way(air, time));
	const glm::dvec2 waves = now - stretch * (before - waves_way(air, time));
	air = wanted;
	air.since = time;
	air.turbulence_way = turbulence;
	air.waves_way = waves;
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
	now.turbulence = map_at(tiles->turbulence, { AirTiles::LENGTH_STEP, AirTiles::SIDE_STEP },
			{ AirTiles::WIDTH, AirTiles::HEIGHT }, heading, turbulence_way(air, time), axes);
	if (now.canopy_wave_amount > 0.0f) {
		now.waves = map_at(tiles->waves, wave_texel(air), { AirTiles::WAVES_WIDTH, AirTiles::WAVES_HEIGHT }, heading,
				waves_way(air, time), axes);
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

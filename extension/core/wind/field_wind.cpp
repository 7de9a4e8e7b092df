#include "wind/field_wind.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float MAX_STRENGTH = 1e9f; // N.
constexpr float MAX_FREQUENCY = 1e4f; // Hz.
constexpr double LONG_AGO = 1e9; // s.
constexpr float SLOWEST = 1e-3f; // m/s; slower winds alias between neighbouring plants.

float safe(float value, float max) {
	return std::isfinite(value) ? std::clamp(value, 0.0f, max) : 0.0f;
}

/// s/m, along the wind.
float slowness(const FieldWind &wind) {
	return std::isfinite(wind.speed) && wind.speed > 0.0f ? 1.0f / std::max(wind.speed, SLOWEST) : 0.0f;
}

double fraction(double value) {
	const double part = value - std::floor(value);
	return std::isfinite(part) && part < 1.0 ? part : 0.0;
}

} // namespace

PlantWinds winds_along(const FieldWind &wind) {
	Wind safe_wind;
	safe_wind.direction = std::isfinite(wind.wind.direction) ? wind.wind.direction : 0.0f;
	const glm::vec3 direction = wind_direction(safe_wind);
	return { nullptr, direction.x, direction.z, direction.z, -direction.x };
}

float wind_delay(const FieldWind &wind, float x, float z) {
	const PlantWinds along = winds_along(wind);
	return slowness(wind) * (along.x * x + along.z * z);
}

WindSnapshot wind_at_time(const FieldWind &field_wind, double time) {
	return wind_at_time(field_wind, winds_along(field_wind), time);
}

WindSnapshot wind_at_time(const FieldWind &field_wind, const PlantWinds &along, double time) {
	const Wind &wind = field_wind.wind;
	const float strength = safe(wind.strength, MAX_STRENGTH);
	const float frequency = safe(wind.frequency, MAX_FREQUENCY);
	WindSnapshot now = {};
	now.steady = wind.kind == WindKind::constant ? strength : 0.0f;
	now.wave = wind.kind == WindKind::waves ? strength : 0.0f;
	now.burst = wind.kind == WindKind::bursts ? strength : 0.0f;
	now.gust = safe(gust_strength(wind), MAX_STRENGTH);
	now.cycle = static_cast<float>(fraction(static_cast<double>(frequency) * time + wind.phase));
	now.delay_x = slowness(field_wind) * along.x;
	now.delay_z = slowness(field_wind) * along.z;
	now.cycles_x = frequency * now.delay_x;
	now.cycles_z = frequency * now.delay_z;
	const double since = time - wind.gust_start;
	now.since = std::isfinite(since) ? static_cast<float>(std::clamp(since, -LONG_AGO, LONG_AGO)) : 0.0f;
	now.min_delay = std::isfinite(field_wind.min_delay) ? field_wind.min_delay : 0.0f;
	now.duration = safe(gust_duration(wind), static_cast<float>(LONG_AGO));
	now.is_air = wind.kind == WindKind::air;
	now.precipitation = field_wind.precipitation;
	if (now.is_air) {
		now.air = air_at_time(field_wind.air, field_wind.axes, field_wind.tiles.get(), time);
	}
	return now;
}

} // namespace undergrowth

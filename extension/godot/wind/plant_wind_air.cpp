// PlantWind: the part for air, in metres per second, as in a weather report.

#include "wind/plant_wind.hpp"

#include "base/convert.hpp"
#include "base/messages.hpp"
#include "base/shortest_decimal.hpp"
#include "conventions.hpp"
#include "wind/air_profile.hpp"
#include "wind/air_tiles_cache.hpp"
#include "wind/wind_shader.hpp"

#include <godot_cpp/classes/shader.hpp>
#include <godot_cpp/classes/shader_material.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace godot;

namespace undergrowth {

static constexpr Range SPEED_RANGE = { 0.0, 100.0 };
static constexpr Range TURBULENCE_RANGE = { -1.0, 2.0 };
static constexpr Range GUSTINESS_RANGE = { 0.0, 0.3 };
static constexpr Range ROUGHNESS_RANGE = { 1e-5, 0.5 };
static constexpr Range CANOPY_HEIGHT_RANGE = { 0.0, 9.0 };
static constexpr Range SHARE_RANGE = { 0.0, 1.0 };
static constexpr Range RAIN_RANGE = { 0.0, 1000.0 };
static constexpr Range BLEND_RANGE = { 0.0, 86400.0 };
static constexpr float FORCE_HEIGHT = 1.0f; // m above the ground: height of the force that sample() returns.

// Changes the air from now on. The patterns continue from their present position.
void PlantWind::take_air(const Air &wanted) {
	change_air(blowing.air, wanted, clock.now());
}

void PlantWind::change(const Air &wanted) {
	blend.duration = 0.0; // A property that is set ends the blend.
	blended.clear();
	take_air(wanted);
	emit_changed();
}

void PlantWind::set_air(float Air::*part, const char *property, double value, const Range &range) {
	if (accept_value(this, property, value, range) && float(value) != blowing.air.*part) {
		Air wanted = blowing.air;
		wanted.*part = float(value);
		change(wanted);
	}
}

void PlantWind::set_speed(double metres_per_second) {
	set_air(&Air::speed, "speed", metres_per_second, SPEED_RANGE);
}

double PlantWind::get_speed() const {
	return shortest_decimal(blowing.air.speed);
}

void PlantWind::set_turbulence(double share) {
	set_air(&Air::turbulence, "turbulence", share, TURBULENCE_RANGE);
}

double PlantWind::get_turbulence() const {
	return shortest_decimal(blowing.air.turbulence);
}

void PlantWind::set_gustiness(double gustiness) {
	set_air(&Air::gustiness, "gustiness", gustiness, GUSTINESS_RANGE);
}

double PlantWind::get_gustiness() const {
	return shortest_decimal(blowing.air.gustiness);
}

void PlantWind::set_roughness(double metres) {
	set_air(&Air::roughness, "roughness", metres, ROUGHNESS_RANGE);
}

double PlantWind::get_roughness() const {
	return shortest_decimal(blowing.air.roughness);
}

void PlantWind::set_canopy_height(double metres) {
	set_air(&Air::canopy_height, "canopy_height", metres, CANOPY_HEIGHT_RANGE);
}

double PlantWind::get_canopy_height() const {
	return shortest_decimal(blowing.air.canopy_height);
}

void PlantWind::set_canopy_wave_amount(double share) {
	set_air(&Air::canopy_wave_amount, "canopy_wave_amount", share, SHARE_RANGE);
}

double PlantWind::get_canopy_wave_amount() const {
	return shortest_decimal(blowing.air.canopy_wave_amount);
}

void PlantWind::set_precipitation(float Precipitation::*part, const char *property, double value, const Range &range) {
	if (accept_value(this, property, value, range) && float(value) != blowing.precipitation.*part) {
		blend.duration = 0.0; // A property that is set ends the blend.
		blowing.precipitation.*part = float(value);
		emit_changed();
	}
}

void PlantWind::set_wetness(double share) {
	set_precipitation(&Precipitation::wetness, "wetness", share, SHARE_RANGE);
}

double PlantWind::get_wetness() const {
	return shortest_decimal(blowing.precipitation.wetness);
}

void PlantWind::set_snow(double share) {
	set_precipitation(&Precipitation::snow, "snow", share, SHARE_RANGE);
}

double PlantWind::get_snow() const {
	return shortest_decimal(blowing.precipitation.snow);
}

void PlantWind::set_rain(double millimetres_per_hour) {
	set_precipitation(&Precipitation::rain, "rain", millimetres_per_hour, RAIN_RANGE);
}

double PlantWind::get_rain() const {
	return shortest_decimal(blowing.precipitation.rain);
}

int64_t PlantWind::get_beaufort() const {
	return beaufort_of(double(blowing.air.speed));
}

// Reports the error once, because velocities may be requested in every frame.
bool PlantWind::is_air(const char *method) const {
	if (blowing.wind.kind != WindKind::air && !has_reported_newtons) {
		report_error(this, String(method) + " needs KIND_AIR: other kinds are forces. Set kind, or call sample().");
		has_reported_newtons = true;
	}
	return blowing.wind.kind == WindKind::air;
}

Vector3 PlantWind::sample_velocity(double at_time, const Vector3 &place) const {
	if (!std::isfinite(at_time) || !place.is_finite()) {
		report_error(this, "sample_velocity() needs a finite time in seconds and a finite position in metres.");
		return Vector3();
	}
	if (!is_air("sample_velocity()")) {
		return Vector3();
	}
	return to_godot(air_velocity(blowing.air, AirTilesCache::get().get(), at_time, to_glm(place)));
}

PackedVector2Array PlantWind::sample_over_canopy(double at_time, const PackedVector2Array &places) const {
	PackedVector2Array velocities;
	std::vector<float> x, z;
	bool is_finite = std::isfinite(at_time);
	for (const Vector2 &place : places) {
		is_finite = is_finite && place.is_finite();
		x.push_back(float(place.x));
		z.push_back(float(place.y));
	}
	if (!is_finite) {
		report_error(this, "sample_over_canopy() needs a finite time in seconds and finite positions in metres.");
		return velocities;
	}
	if (!is_air("sample_over_canopy()")) {
		return velocities;
	}
	const FieldWind field = travelling();
	const WindSnapshot now = wind_at_time(field, at_time);
	const AirMoments moments =
			moments_over(now.air, std::max(field.air.canopy_height, TURF_HEIGHT), winds_along(field));
	std::vector<float> out_x(x.size()), out_z(x.size());
	sample_air(now, moments, x.data(), z.data(), nullptr, int(x.size()), out_x.data(), out_z.data());
	for (size_t i = 0; i < x.size(); i++) {
		velocities.push_back(Vector2(out_x[i], out_z[i]));
	}
	return velocities;
}

Vector3 PlantWind::sample_air_force(double at_time) const {
	const Vector3 velocity = sample_velocity(at_time, Vector3(0, FORCE_HEIGHT, 0));
	return velocity * (0.5 * AIR_DENSITY * velocity.length());
}

void PlantWind::apply_to_material(const Ref<Material> &material) const {
	const ShaderMaterial *shaded = Object::cast_to<ShaderMaterial>(material.ptr());
	if (!shaded || shaded->get_shader().is_null()) {
		report_error(this, "apply_to_material() needs a material whose shader includes undergrowth_wind.gdshaderinc.");
	} else if (is_air("apply_to_material()")) {
		show_wind(travelling(), clock.now(), material);
	}
}

void PlantWind::blend_to(const Ref<PlantWind> &wind, double seconds) {
	if (wind.is_null() || wind->get_kind() != KIND_AIR || get_kind() != KIND_AIR) {
		report_error(this, "blend_to() needs KIND_AIR in both winds; nothing was changed. Set the kind of both.");
		return;
	}
	if (!accept_value(this, "the blend's seconds", seconds, BLEND_RANGE)) {
		return;
	}
	blend.from = blowing.air;
	blend.to = wind->blowing.air;
	blend.wet_from = blowing.precipitation;
	blend.wet_to = wind->blowing.precipitation;
	// Turns by the smaller angle.
	blend.to.heading = blend.from.heading + std::remainder(blend.to.heading - blend.from.heading, 2.0 * PI);
	blend.begin = clock.now();
	blend.duration = std::max(seconds, 1e-9);
	if (seconds == 0.0) {
		set_clock(clock);
	}
}

static Air mixed(const Air &from, const Air &to, double share) {
	const auto part = float(share);
	const auto turbulence = [](const Air &air) {
		return air.turbulence < 0.0f ? float(open_ground_gusts(REFERENCE_HEIGHT, double(air.roughness)))
									 : air.turbulence;
	};
	Air air = from;
	air.speed = glm::mix(from.speed, to.speed, part);
	air.gustiness = glm::mix(from.gustiness, to.gustiness, part);
	air.roughness = glm::mix(from.roughness, to.roughness, part);
	air.canopy_height = glm::mix(from.canopy_height, to.canopy_height, part);
	air.canopy_wave_amount = glm::mix(from.canopy_wave_amount, to.canopy_wave_amount, part);
	air.heading = glm::mix(from.heading, to.heading, share);
	if (from.turbulence >= 0.0f || to.turbulence >= 0.0f) {
		air.turbulence = glm::mix(turbulence(from), turbulence(to), part);
	}
	return air;
}

static Precipitation mixed(const Precipitation &from, const Precipitation &to, double share) {
	const auto part = float(share);
	return { glm::mix(from.wetness, to.wetness, part), glm::mix(from.snow, to.snow, part),
		glm::mix(from.rain, to.rain, part) };
}

void PlantWind::set_clock(const StepTime &next) {
	if (blend.duration > 0.0) {
		const double share = std::clamp((next.now() - blend.begin) / blend.duration, 0.0, 1.0);
		const bool is_there = share >= 1.0 || next.now() == blend.begin;
		take_air(is_there ? blend.to : mixed(blend.from, blend.to, share));
		blowing.precipitation = is_there ? blend.wet_to : mixed(blend.wet_from, blend.wet_to, share);
		direction = blowing.air.heading;
		blowing.wind.direction = float(direction);
		if (is_there) {
			blend.duration = 0.0;
			emit_changed();
		}
	}
	clock = next;
}

FieldWind PlantWind::travelling() const {
	FieldWind now = blowing;
	if (now.wind.kind == WindKind::air) {
		now.speed = float(turbulence_speed(now.air));
		now.tiles = AirTilesCache::get();
	}
	return now;
}

} // namespace undergrowth

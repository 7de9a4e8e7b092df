// PlantWind: the part for all kinds. plant_wind_air.cpp has the part for air.

#include "wind/plant_wind.hpp"

#include "base/convert.hpp"
#include "base/messages.hpp"
#include "base/shortest_decimal.hpp"
#include "conventions.hpp"
#include "plants/plant_simulation.hpp"
#include "wind/air_tiles_cache.hpp"
#include "wind/wind_shader.hpp"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr Range STRENGTH_RANGE = { 0.0, 1e6 };
static constexpr Range DIRECTION_RANGE = { -200.0 * PI, 200.0 * PI };
static constexpr Range FREQUENCY_RANGE = { 0.0, 1000.0 };
static constexpr Range GUST_DURATION_RANGE = { 0.0, 3600.0 };
static constexpr Range TRAVEL_SPEED_RANGE = { 0.0, 1e4 };

// By default a moderate wind that never stops, so that its effect is visible.
PlantWind::PlantWind() {
	blowing.wind.kind = WindKind::waves;
	blowing.wind.strength = 5.0f;
	blowing.wind.frequency = 0.4f;
	blowing.air.speed = 5.0f;
}

void PlantWind::set_kind(Kind kind) {
	if (kind < KIND_GUST || kind > KIND_AIR) {
		report_error(this, "kind " + String::num_int64(kind) + " does not exist. Use one of the KIND_ constants.");
		return;
	}
	if (WindKind(kind) == blowing.wind.kind) {
		return;
	}
	blowing.wind.kind = WindKind(kind);
	blowing.wind.gust_triggered = false;
	if (kind == KIND_AIR) {
		AirTilesCache::begin();
	}
	begin_gust(); // A gust that is selected during the simulation starts now.
	notify_property_list_changed();
	emit_changed();
}

PlantWind::Kind PlantWind::get_kind() const {
	return Kind(int(blowing.wind.kind));
}

void PlantWind::set_number(float &slot, const char *property, double value, const Range &range) {
	if (!accept_value(this, property, value, range) || slot == float(value)) {
		return;
	}
	slot = float(value);
	emit_changed();
}

void PlantWind::set_strength(double newtons) {
	set_number(blowing.wind.strength, "strength", newtons, STRENGTH_RANGE);
}

double PlantWind::get_strength() const {
	return shortest_decimal(blowing.wind.strength);
}

void PlantWind::set_direction(double radians) {
	if (accept_value(this, "direction", radians, DIRECTION_RANGE) && radians != direction) {
		direction = radians;
		blowing.wind.direction = float(radians);
		Air turned = blowing.air;
		turned.heading = radians;
		change(turned);
	}
}

double PlantWind::get_direction() const {
	return direction;
}

void PlantWind::set_frequency(double hertz) {
	if (accept_value(this, "frequency", hertz, FREQUENCY_RANGE) && float(hertz) != blowing.wind.frequency) {
		change_frequency(blowing.wind, float(hertz), clock.now());
		emit_changed();
	}
}

double PlantWind::get_frequency() const {
	return shortest_decimal(blowing.wind.frequency);
}

void PlantWind::set_gust_duration(double seconds) {
	set_number(blowing.wind.gust_duration, "gust_duration", seconds, GUST_DURATION_RANGE);
}

double PlantWind::get_gust_duration() const {
	return shortest_decimal(blowing.wind.gust_duration);
}

void PlantWind::set_travel_speed(double metres_per_second) {
	set_number(blowing.speed, "travel_speed", metres_per_second, TRAVEL_SPEED_RANGE);
}

double PlantWind::get_travel_speed() const {
	return shortest_decimal(blowing.speed);
}

Vector3 PlantWind::sample(double at_time) const {
	if (!std::isfinite(at_time)) {
		report_error(this, "sample() needs a finite time in seconds.");
		return Vector3();
	}
	if (blowing.wind.kind == WindKind::air) {
		return sample_air_force(at_time);
	}
	return to_godot(wind_force(blowing.wind, at_time));
}

void PlantWind::begin_gust() {
	blowing.wind.gust_start = clock.now();
	gusts++;
}

void PlantWind::trigger_gust(double strength, double duration) {
	const bool own_strength = strength < 0.0;
	const bool own_duration = duration < 0.0;
	if ((!own_strength && !accept_value(this, "the gust's strength", strength, STRENGTH_RANGE)) ||
			(!own_duration && !accept_value(this, "the gust's duration", duration, GUST_DURATION_RANGE))) {
		return;
	}
	blowing.wind.gust_triggered = true;
	blowing.wind.triggered_strength = own_strength ? -1.0f : float(strength);
	blowing.wind.triggered_duration = own_duration ? -1.0f : float(duration);
	begin_gust();
}

static PlantWind *shown_in_shaders = nullptr;

PlantWind *PlantWind::scene_wind() {
	return shown_in_shaders;
}

PlantWind::~PlantWind() {
	set_scene_wind(false);
}

void PlantWind::set_scene_wind(bool on) {
	if (on == is_scene_wind) {
		return;
	}
	is_scene_wind = on;
	if (on) {
		if (shown_in_shaders) {
			report_warning(this,
					"replaces another scene wind in the global shader parameters. Disable scene_wind in one of the "
					"two.");
		}
		shown_in_shaders = this;
		add_scene_wind_parameters();
		PlantSimulation::follow_main_loop();
		show_in_shaders(0.0);
	} else if (shown_in_shaders == this) {
		shown_in_shaders = nullptr;
		calm_scene_wind();
	}
	emit_changed();
}

void PlantWind::show_in_shaders(double seconds) const {
	if (shown_in_shaders == this) {
		blowing.wind.kind == WindKind::air ? show_scene_wind(travelling(), clock.now() - seconds) : calm_scene_wind();
	}
}

double PlantWind::get_time() const {
	return clock.now();
}

void PlantWind::advance(double seconds) {
	if (!std::isfinite(seconds) || seconds < 0.0) {
		report_error(
				this, "advance(" + String::num(seconds) + ") is invalid; the time stays. Pass seconds of 0 or more.");
		return;
	}
	blended.clear();
	set_clock(clock.moved_to(clock.now() + seconds));
	show_in_shaders(0.0);
}

void PlantWind::advance_step(uint64_t number, double length) {
	if (number != last_step) {
		last_step = number;
		const bool is_blending = blend.duration > 0.0 || !blended.empty();
		set_clock(clock.next(length));
		if (is_blending) {
			blended.push_back(travelling());
		}
	}
}

void PlantWind::catch_up_to(double seconds) {
	if (seconds > clock.now()) {
		set_clock(clock.moved_to(seconds));
	}
}

FieldWind PlantWind::for_listener(Listener &listener, double seconds) const {
	if (listener.received_gusts != gusts) {
		listener.received_gusts = gusts;
		listener.gust_start = seconds - (clock.now() - blowing.wind.gust_start);
	}
	FieldWind wind = travelling();
	if (gusts > 0) {
		wind.wind.gust_start = listener.gust_start;
	}
	return wind;
}

} // namespace undergrowth

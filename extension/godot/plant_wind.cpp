#include "plant_wind.hpp"

#include "as_written.hpp"
#include "conventions.hpp"
#include "convert.hpp"
#include "messages.hpp"

#include <godot_cpp/core/class_db.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr Range STRENGTH_RANGE = { 0.0, 1e6 };
static constexpr Range DIRECTION_RANGE = { -200.0 * PI, 200.0 * PI };
static constexpr Range FREQUENCY_RANGE = { 0.0, 1000.0 };
static constexpr Range GUST_DURATION_RANGE = { 0.0, 3600.0 };
static constexpr Range TRAVEL_SPEED_RANGE = { 0.0, 1e4 };

// A wind that never comes to rest, and no gale: what it moves shows that it blows.
PlantWind::PlantWind() {
	air.wind.kind = WindKind::waves;
	air.wind.strength = 5.0f;
	air.wind.frequency = 0.4f;
}

void PlantWind::set_kind(Kind kind) {
	if (kind < KIND_GUST || kind > KIND_WAVES) {
		report_error(this, "kind " + String::num_int64(kind) + " does not exist. Use one of the KIND_ constants.");
		return;
	}
	if (WindKind(kind) == air.wind.kind) {
		return;
	}
	air.wind.kind = WindKind(kind);
	air.wind.gust_triggered = false;
	begin_gust(); // A gust that is chosen while the simulation runs blows now.
	notify_property_list_changed();
	emit_changed();
}

PlantWind::Kind PlantWind::get_kind() const {
	return Kind(int(air.wind.kind));
}

void PlantWind::set_number(float &slot, const char *property, double value, const Range &range) {
	if (!accept_value(this, property, value, range) || slot == float(value)) {
		return;
	}
	slot = float(value);
	emit_changed();
}

void PlantWind::set_strength(double newtons) {
	set_number(air.wind.strength, "strength", newtons, STRENGTH_RANGE);
}

double PlantWind::get_strength() const {
	return as_written(air.wind.strength);
}

void PlantWind::set_direction(double radians) {
	if (accept_value(this, "direction", radians, DIRECTION_RANGE) && radians != direction) {
		direction = radians;
		air.wind.direction = float(radians);
		emit_changed();
	}
}

double PlantWind::get_direction() const {
	return direction;
}

void PlantWind::set_frequency(double hertz) {
	if (accept_value(this, "frequency", hertz, FREQUENCY_RANGE) && float(hertz) != air.wind.frequency) {
		change_frequency(air.wind, float(hertz), time);
		emit_changed();
	}
}

double PlantWind::get_frequency() const {
	return as_written(air.wind.frequency);
}

void PlantWind::set_gust_duration(double seconds) {
	set_number(air.wind.gust_duration, "gust_duration", seconds, GUST_DURATION_RANGE);
}

double PlantWind::get_gust_duration() const {
	return as_written(air.wind.gust_duration);
}

void PlantWind::set_travel_speed(double metres_per_second) {
	set_number(air.speed, "travel_speed", metres_per_second, TRAVEL_SPEED_RANGE);
}

double PlantWind::get_travel_speed() const {
	return as_written(air.speed);
}

Vector3 PlantWind::sample(double at_time) const {
	if (!std::isfinite(at_time)) {
		report_error(this, "sample() needs a finite time in seconds.");
		return Vector3();
	}
	return to_godot(wind_force(air.wind, at_time));
}

void PlantWind::begin_gust() {
	air.wind.gust_start = time;
	gusts++;
}

void PlantWind::trigger_gust(double strength, double duration) {
	const bool own_strength = strength < 0.0;
	const bool own_duration = duration < 0.0;
	if ((!own_strength && !accept_value(this, "the gust's strength", strength, STRENGTH_RANGE)) ||
			(!own_duration && !accept_value(this, "the gust's duration", duration, GUST_DURATION_RANGE))) {
		return;
	}
	air.wind.gust_triggered = true;
	air.wind.triggered_strength = own_strength ? -1.0f : float(strength);
	air.wind.triggered_duration = own_duration ? -1.0f : float(duration);
	begin_gust();
}

double PlantWind::get_time() const {
	return time;
}

void PlantWind::advance(double step) {
	if (!std::isfinite(step) || step < 0.0) {
		report_error(
				this, "advance(" + String::num(step) + ") is impossible; its time stays. Pass seconds of 0 or more.");
		return;
	}
	time += step;
}

void PlantWind::keep_up_with(double clock) {
	time = std::max(time, clock);
}

FieldWind PlantWind::heard_by(Listener &listener, double clock) const {
	if (listener.heard != gusts) {
		listener.heard = gusts;
		listener.gust_start = clock - (time - air.wind.gust_start);
	}
	FieldWind heard = air;
	if (gusts > 0) {
		heard.wind.gust_start = listener.gust_start;
	}
	return heard;
}

double PlantWind::begin_step(uint64_t number, double step) {
	if (number != begun_step) {
		begun_step = number;
		step_start = time;
		time += step;
	}
	return step_start;
}

void PlantWind::_validate_property(PropertyInfo &property) const {
	const bool periodic = air.wind.kind == WindKind::bursts || air.wind.kind == WindKind::waves;
	if (property.name == StringName("frequency") && !periodic) {
		property.usage = PROPERTY_USAGE_NO_EDITOR;
	}
}

void PlantWind::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_kind", "kind"), &PlantWind::set_kind);
	ClassDB::bind_method(D_METHOD("get_kind"), &PlantWind::get_kind);
	ClassDB::bind_method(D_METHOD("set_strength", "newtons"), &PlantWind::set_strength);
	ClassDB::bind_method(D_METHOD("get_strength"), &PlantWind::get_strength);
	ClassDB::bind_method(D_METHOD("set_direction", "radians"), &PlantWind::set_direction);
	ClassDB::bind_method(D_METHOD("get_direction"), &PlantWind::get_direction);
	ClassDB::bind_method(D_METHOD("set_frequency", "hertz"), &PlantWind::set_frequency);
	ClassDB::bind_method(D_METHOD("get_frequency"), &PlantWind::get_frequency);
	ClassDB::bind_method(D_METHOD("set_gust_duration", "seconds"), &PlantWind::set_gust_duration);
	ClassDB::bind_method(D_METHOD("get_gust_duration"), &PlantWind::get_gust_duration);
	ClassDB::bind_method(D_METHOD("sample", "time"), &PlantWind::sample);
	ClassDB::bind_method(D_METHOD("set_travel_speed", "metres_per_second"), &PlantWind::set_travel_speed);
	ClassDB::bind_method(D_METHOD("get_travel_speed"), &PlantWind::get_travel_speed);
	ClassDB::bind_method(
			D_METHOD("trigger_gust", "strength", "duration"), &PlantWind::trigger_gust, DEFVAL(-1.0), DEFVAL(-1.0));
	ClassDB::bind_method(D_METHOD("get_time"), &PlantWind::get_time);
	ClassDB::bind_method(D_METHOD("advance", "seconds"), &PlantWind::advance);

	ADD_PROPERTY(PropertyInfo(Variant::INT, "kind", PROPERTY_HINT_ENUM, "Gust,Constant,Bursts,Waves"), "set_kind",
			"get_kind");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "strength", PROPERTY_HINT_RANGE, "0,50,0.1,or_greater,suffix:N"),
			"set_strength", "get_strength");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "direction", PROPERTY_HINT_RANGE,
						 "0,360,0.1,or_less,or_greater,radians_as_degrees"),
			"set_direction", "get_direction");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "frequency", PROPERTY_HINT_RANGE, "0,5,0.01,or_greater,suffix:Hz"),
			"set_frequency", "get_frequency");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "gust_duration", PROPERTY_HINT_RANGE, "0,10,0.01,or_greater,suffix:s"),
			"set_gust_duration", "get_gust_duration");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "travel_speed", PROPERTY_HINT_RANGE, "0,50,0.1,or_greater,suffix:m/s"),
			"set_travel_speed", "get_travel_speed");

	BIND_ENUM_CONSTANT(KIND_GUST);
	BIND_ENUM_CONSTANT(KIND_CONSTANT);
	BIND_ENUM_CONSTANT(KIND_BURSTS);
	BIND_ENUM_CONSTANT(KIND_WAVES);
}

} // namespace undergrowth

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
static constexpr Range DIRECTION_RANGE = { -36000.0, 36000.0 };
static constexpr Range FREQUENCY_RANGE = { 0.0, 1000.0 };
static constexpr Range GUST_DURATION_RANGE = { 0.0, 3600.0 };
static constexpr double RADIANS_PER_DEGREE = PI / 180.0;

void PlantWind::set_kind(Kind kind) {
	if (kind < KIND_GUST || kind > KIND_WAVES) {
		report_error(this, "kind " + String::num_int64(kind) + " does not exist. Use one of the KIND_ constants.");
		return;
	}
	if (WindKind(kind) == wind.kind) {
		return;
	}
	wind.kind = WindKind(kind);
	wind.gust_start = time; // A gust that is chosen while the simulation runs blows now.
	wind.gust_triggered = false;
	notify_property_list_changed();
	emit_changed();
}

PlantWind::Kind PlantWind::get_kind() const {
	return Kind(int(wind.kind));
}

void PlantWind::set_strength(double newtons) {
	if (accept_value(this, "strength", newtons, STRENGTH_RANGE)) {
		wind.strength = float(newtons);
		emit_changed();
	}
}

double PlantWind::get_strength() const {
	return as_written(wind.strength);
}

void PlantWind::set_direction_degrees(double degrees) {
	if (accept_value(this, "direction_degrees", degrees, DIRECTION_RANGE)) {
		wind.direction = float(degrees * RADIANS_PER_DEGREE);
		emit_changed();
	}
}

double PlantWind::get_direction_degrees() const {
	return as_written(float(wind.direction / RADIANS_PER_DEGREE));
}

void PlantWind::set_frequency(double hertz) {
	if (accept_value(this, "frequency", hertz, FREQUENCY_RANGE)) {
		change_frequency(wind, float(hertz), time);
		emit_changed();
	}
}

double PlantWind::get_frequency() const {
	return as_written(wind.frequency);
}

void PlantWind::set_gust_duration(double seconds) {
	if (accept_value(this, "gust_duration", seconds, GUST_DURATION_RANGE)) {
		wind.gust_duration = float(seconds);
		emit_changed();
	}
}

double PlantWind::get_gust_duration() const {
	return as_written(wind.gust_duration);
}

Vector3 PlantWind::sample(double at_time) const {
	if (!std::isfinite(at_time)) {
		report_error(this, "sample() needs a finite time in seconds.");
		return Vector3();
	}
	return to_godot(wind_force(wind, at_time));
}

void PlantWind::trigger_gust() {
	wind.gust_start = time;
	wind.gust_triggered = true;
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

glm::vec3 PlantWind::force_of_step(uint64_t number, double step) {
	if (number != sampled_step) {
		sampled_step = number;
		time += step;
		sampled_force = wind_force(wind, time);
	}
	return sampled_force;
}

void PlantWind::_validate_property(PropertyInfo &property) const {
	const bool periodic = wind.kind == WindKind::bursts || wind.kind == WindKind::waves;
	if (property.name == StringName("frequency") && !periodic) {
		property.usage = PROPERTY_USAGE_NO_EDITOR;
	}
}

void PlantWind::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_kind", "kind"), &PlantWind::set_kind);
	ClassDB::bind_method(D_METHOD("get_kind"), &PlantWind::get_kind);
	ClassDB::bind_method(D_METHOD("set_strength", "newtons"), &PlantWind::set_strength);
	ClassDB::bind_method(D_METHOD("get_strength"), &PlantWind::get_strength);
	ClassDB::bind_method(D_METHOD("set_direction_degrees", "degrees"), &PlantWind::set_direction_degrees);
	ClassDB::bind_method(D_METHOD("get_direction_degrees"), &PlantWind::get_direction_degrees);
	ClassDB::bind_method(D_METHOD("set_frequency", "hertz"), &PlantWind::set_frequency);
	ClassDB::bind_method(D_METHOD("get_frequency"), &PlantWind::get_frequency);
	ClassDB::bind_method(D_METHOD("set_gust_duration", "seconds"), &PlantWind::set_gust_duration);
	ClassDB::bind_method(D_METHOD("get_gust_duration"), &PlantWind::get_gust_duration);
	ClassDB::bind_method(D_METHOD("sample", "time"), &PlantWind::sample);
	ClassDB::bind_method(D_METHOD("trigger_gust"), &PlantWind::trigger_gust);
	ClassDB::bind_method(D_METHOD("get_time"), &PlantWind::get_time);
	ClassDB::bind_method(D_METHOD("advance", "seconds"), &PlantWind::advance);

	ADD_PROPERTY(PropertyInfo(Variant::INT, "kind", PROPERTY_HINT_ENUM, "Gust,Constant,Bursts,Waves"), "set_kind",
			"get_kind");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "strength", PROPERTY_HINT_RANGE, "0,50,0.1,or_greater,suffix:N"),
			"set_strength", "get_strength");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "direction_degrees", PROPERTY_HINT_RANGE,
						 String::utf8("0,360,0.1,or_less,or_greater,suffix:°")),
			"set_direction_degrees", "get_direction_degrees");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "frequency", PROPERTY_HINT_RANGE, "0,5,0.01,or_greater,suffix:Hz"),
			"set_frequency", "get_frequency");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "gust_duration", PROPERTY_HINT_RANGE, "0,10,0.01,or_greater,suffix:s"),
			"set_gust_duration", "get_gust_duration");

	BIND_ENUM_CONSTANT(KIND_GUST);
	BIND_ENUM_CONSTANT(KIND_CONSTANT);
	BIND_ENUM_CONSTANT(KIND_BURSTS);
	BIND_ENUM_CONSTANT(KIND_WAVES);
}

} // namespace undergrowth

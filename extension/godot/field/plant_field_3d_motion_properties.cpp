// What users set of a PlantField3D: how plants move.

#include "field/plant_field_3d.hpp"

#include "follow_changes.hpp"

using namespace godot;

namespace undergrowth {

static constexpr Range WIND_SPEED_RANGE = { 0.0, 10000.0 };
static constexpr Range FAR_DISTANCE_RANGE = { 0.0, 1e6 };
static constexpr Range TOUCH_MARGIN_RANGE = { 0.0, 100.0 };
static constexpr Range THREADS_RANGE = { 0, 256 };
static constexpr Range PROTOTYPES_RANGE = { 0, 64 };
static constexpr Range INTERVAL_RANGE = { 1, 64 };

void PlantField3D::set_wind(const Ref<PlantWind> &new_wind) {
	const Callable changed(this, "_on_wind_changed");
	unfollow_changes(wind.ptr(), changed);
	wind = new_wind;
	follow_changes(wind.ptr(), changed);
	seen_wind_time = -1.0;
	update_configuration_warnings();
}

Ref<PlantWind> PlantField3D::get_wind() const {
	return wind;
}

void PlantField3D::set_wind_speed(double value) {
	set_number(options.wind_speed, "wind_speed", value, WIND_SPEED_RANGE, false);
}

double PlantField3D::get_wind_speed() const {
	return options.wind_speed;
}

void PlantField3D::set_simulating(bool on) {
	options.simulating = on;
	if (!on && simulation) {
		finish_step();
		upload(); // What it was the last to do is seen, too.
	}
	update_processing();
}

bool PlantField3D::is_simulating() const {
	return options.simulating;
}

void PlantField3D::set_threads(int value) {
	set_whole(options.threads, "threads", value, THREADS_RANGE, false);
}

int PlantField3D::get_threads() const {
	return options.threads;
}

void PlantField3D::set_update_interval(int step_count) {
	set_whole(options.update_interval, "update_interval", step_count, INTERVAL_RANGE, false);
	if (simulation) {
		finish_step();
		simulation->set_update_interval(options.update_interval);
	}
}

int PlantField3D::get_update_interval() const {
	return options.update_interval;
}

void PlantField3D::set_far_distance(double value) {
	set_number(options.far_distance, "far_distance", value, FAR_DISTANCE_RANGE, false);
}

double PlantField3D::get_far_distance() const {
	return options.far_distance;
}

void PlantField3D::set_prototypes(int value) {
	set_whole(options.prototypes, "prototypes", value, PROTOTYPES_RANGE, true);
	update_configuration_warnings();
}

int PlantField3D::get_prototypes() const {
	return options.prototypes;
}

void PlantField3D::set_contact(bool on) {
	options.contact = on;
	update_configuration_warnings();
	if (on && simulation) {
		finish_step();
		touching.fit(*simulation);
	}
}

bool PlantField3D::has_contact() const {
	return options.contact;
}

void PlantField3D::set_bodies_group(const StringName &group) {
	bodies_group = group;
}

StringName PlantField3D::get_bodies_group() const {
	return bodies_group;
}

void PlantField3D::set_touch_margin(double value) {
	set_number(options.touch_margin, "touch_margin", value, TOUCH_MARGIN_RANGE, false);
}

double PlantField3D::get_touch_margin() const {
	return options.touch_margin;
}

} // namespace undergrowth

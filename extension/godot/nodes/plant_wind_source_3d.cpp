#include "nodes/plant_wind_source_3d.hpp"

#include "base/convert.hpp"
#include "base/shortest_decimal.hpp"
#include "base/world_of.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr Range SPEED_RANGE = { 0.0, 340.0 };
static constexpr Range THRUST_RANGE = { 0.0, 1e7 };
static constexpr Range RADIUS_RANGE = { 0.01, 1000.0 };
static constexpr Range DURATION_RANGE = { 0.01, 10.0 };
static constexpr float FASTEST = 150.0f; // m/s; a faster node was moved to another position.
static constexpr float FAN_UNREST = 0.3f; // Of a jet on a wall.
static constexpr float EXPLOSION_ENDS = 10.0f; // In durations, without the travel time of the front.

// All sources in a tree. Main thread.
static std::vector<PlantWindSource3D *> &in_tree() {
	static std::vector<PlantWindSource3D *> all;
	return all;
}

PlantWindSource3D::PlantWindSource3D() {
	air.radius = 3.0f;
	air.unrest = FAN_UNREST;
}

bool PlantWindSource3D::stirs_now() const {
	return active && (air.kind != AirSource::Kind::explosion || is_exploding);
}

AirSource PlantWindSource3D::at(double ago) const {
	AirSource then = air;
	then.place = way.place(ago);
	then.velocity = way.velocity(ago);
	if (glm::length(then.velocity) >= FASTEST) {
		then.velocity = glm::vec3(0.0f);
	}
	then.height = std::max(then.place.y, 0.0f);
	then.speed = air.kind == AirSource::Kind::fan ? induced_speed(thrust, air.radius) : speed;
	then.age -= float(ago);
	then.eddies -= float(ago) * eddy_rate(then.speed, air.radius);
	return then;
}

void PlantWindSource3D::gather(uint64_t world, double ago, std::vector<AirSource> &into) {
	follow_all();
	into.clear();
	for (const PlantWindSource3D *source : in_tree()) {
		if (source->world == world && source->stirs_now()) {
			into.push_back(source->at(ago));
		}
	}
}

void PlantWindSource3D::gather_in(uint64_t world, const Transform3D &axes, double ago, std::vector<AirSource> &into) {
	gather(world, ago, into);
	if (into.empty()) {
		return;
	}
	const Transform3D to_field = axes.affine_inverse();
	const Basis turn = axes.basis.orthonormalized().transposed();
	const float scale = float(std::cbrt(std::fabs(double(axes.basis.determinant()))));
	for (AirSource &source : into) {
		source.place = to_glm(to_field.xform(to_godot(source.place)));
		source.velocity = to_glm(turn.xform(to_godot(source.velocity)));
		source.scale = scale;
	}
}

// Runs at its first call in a frame. If nothing simulates, as in the editor, that is by a source or a preview.
void PlantWindSource3D::follow_all() {
	static uint64_t followed = 0;
	const uint64_t frame = Engine::get_singleton()->get_process_frames();
	if (frame == followed) {
		return;
	}
	followed = frame;
	for (PlantWindSource3D *source : in_tree()) {
		if (source->can_process()) {
			source->follow(source->get_process_delta_time());
		}
	}
}

void PlantWindSource3D::follow(double delta) {
	const glm::vec3 place = to_glm(get_global_position());
	const double tick = 1.0 / std::max(Engine::get_singleton()->get_physics_ticks_per_second(), 1);
	const bool is_jump = !(glm::distance(place, way.last()) < FASTEST * float(std::max(delta, tick)));
	if (is_jump) {
		way.begin(place);
	} else {
		way.add(delta, place);
	}
	if (active && air.kind == AirSource::Kind::fan) {
		const float turned = float(delta) * eddy_rate(induced_speed(thrust, air.radius), air.radius);
		air.eddies = std::fmod(air.eddies + turned, EDDY_TURNS);
	}
	if (is_exploding) {
		air.age += float(delta);
		is_exploding = air.age < EXPLOSION_ENDS * air.duration + reach_of(air) / air.front;
	}
}

void PlantWindSource3D::_notification(int what) {
	switch (what) {
		case NOTIFICATION_ENTER_TREE:
			in_tree().push_back(this);
			set_process_internal(true);
			way.begin(to_glm(get_global_position()));
			break;
		case NOTIFICATION_EXIT_TREE:
			in_tree().erase(std::remove(in_tree().begin(), in_tree().end(), this), in_tree().end());
			break;
		case NOTIFICATION_ENTER_WORLD:
			world = world_of(this);
			break;
		case NOTIFICATION_INTERNAL_PROCESS:
			follow_all();
			break;
		default:
			break;
	}
}

void PlantWindSource3D::set_kind(Kind new_kind) {
	if (new_kind < KIND_EXPLOSION || new_kind > KIND_WAKE) {
		report_error(this, "kind " + String::num_int64(new_kind) + " does not exist. Use one of the KIND_ constants.");
		return;
	}
	air.kind = AirSource::Kind(int(new_kind));
	is_exploding = false;
	notify_property_list_changed();
}

PlantWindSource3D::Kind PlantWindSource3D::get_kind() const {
	return Kind(int(air.kind));
}

void PlantWindSource3D::set_number(float &slot, const char *property, double value, const Range &range) {
	if (accept_value(this, property, value, range)) {
		slot = float(value);
	}
}

void PlantWindSource3D::set_speed(double metres_per_second) {
	set_number(speed, "speed", metres_per_second, SPEED_RANGE);
}

double PlantWindSource3D::get_speed() const {
	return shortest_decimal(speed);
}

void PlantWindSource3D::set_thrust(double newtons) {
	set_number(thrust, "thrust", newtons, THRUST_RANGE);
}

double PlantWindSource3D::get_thrust() const {
	return shortest_decimal(thrust);
}

void PlantWindSource3D::set_radius(double metres) {
	set_number(air.radius, "radius", metres, RADIUS_RANGE);
}

double PlantWindSource3D::get_radius() const {
	return shortest_decimal(air.radius);
}

void PlantWindSource3D::set_duration(double seconds) {
	set_number(air.duration, "duration", seconds, DURATION_RANGE);
}

double PlantWindSource3D::get_duration() const {
	return shortest_decimal(air.duration);
}

void PlantWindSource3D::set_active(bool stirs) {
	active = stirs;
}

void PlantWindSource3D::explode() {
	if (air.kind != AirSource::Kind::explosion) {
		report_error(this, "explode() needs KIND_EXPLOSION. Set kind.");
		return;
	}
	air.age = 0.0f;
	is_exploding = true;
}

void PlantWindSource3D::_validate_property(PropertyInfo &property) const {
	const String name = property.name;
	const bool is_explosion = air.kind == AirSource::Kind::explosion;
	const bool is_hidden = name == String("thrust")
			? air.kind != AirSource::Kind::fan
			: (name == String("speed") || name == String("duration")) && !is_explosion;
	if (is_hidden) {
		property.usage = PROPERTY_USAGE_NO_EDITOR;
	}
}

void PlantWindSource3D::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_kind", "kind"), &PlantWindSource3D::set_kind);
	ClassDB::bind_method(D_METHOD("get_kind"), &PlantWindSource3D::get_kind);
	ClassDB::bind_method(D_METHOD("set_active", "active"), &PlantWindSource3D::set_active);
	ClassDB::bind_method(D_METHOD("is_active"), &PlantWindSource3D::is_active);
	ClassDB::bind_method(D_METHOD("set_radius", "metres"), &PlantWindSource3D::set_radius);
	ClassDB::bind_method(D_METHOD("get_radius"), &PlantWindSource3D::get_radius);
	ClassDB::bind_method(D_METHOD("set_speed", "metres_per_second"), &PlantWindSource3D::set_speed);
	ClassDB::bind_method(D_METHOD("get_speed"), &PlantWindSource3D::get_speed);
	ClassDB::bind_method(D_METHOD("set_duration", "seconds"), &PlantWindSource3D::set_duration);
	ClassDB::bind_method(D_METHOD("get_duration"), &PlantWindSource3D::get_duration);
	ClassDB::bind_method(D_METHOD("set_thrust", "newtons"), &PlantWindSource3D::set_thrust);
	ClassDB::bind_method(D_METHOD("get_thrust"), &PlantWindSource3D::get_thrust);
	ClassDB::bind_method(D_METHOD("explode"), &PlantWindSource3D::explode);

	ADD_PROPERTY(PropertyInfo(Variant::INT, "kind", PROPERTY_HINT_ENUM, "Explosion,Fan,Wake"), "set_kind", "get_kind");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "active"), "set_active", "is_active");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "radius", PROPERTY_HINT_RANGE, "0.1,20,0.01,or_greater,suffix:m"),
			"set_radius", "get_radius");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "speed", PROPERTY_HINT_RANGE, "0,340,0.1,suffix:m/s"), "set_speed",
			"get_speed");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "duration", PROPERTY_HINT_RANGE, "0.01,1,0.01,or_greater,suffix:s"),
			"set_duration", "get_duration");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "thrust", PROPERTY_HINT_RANGE, "0,50000,1,or_greater,suffix:N"),
			"set_thrust", "get_thrust");

	BIND_ENUM_CONSTANT(KIND_EXPLOSION);
	BIND_ENUM_CONSTANT(KIND_FAN);
	BIND_ENUM_CONSTANT(KIND_WAKE);
}

} // namespace undergrowth

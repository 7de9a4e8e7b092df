// Plant3D: queries of scripts, and bindings.

#include "nodes/plant_3d.hpp"

#include "base/convert.hpp"

#include <godot_cpp/core/class_db.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

Vector3 Plant3D::arm(float share) const {
	glm::vec3 found;
	if (motion.find_arm(share, found)) {
		return plant_transform.axes.xform_inv(to_godot(found));
	}
	const glm::vec3 own = to_glm(plant_transform.axes.xform_inv(to_godot(motion.motion_state(rest()).now.direction)));
	return to_godot(view.arm(own, share));
}

int Plant3D::get_joint_count() {
	get_mesh();
	return std::max(view.joint_count(), 1);
}

Vector3 Plant3D::get_tip_position() const {
	return arm(1.0f) * view.height();
}

Vector3 Plant3D::get_joint_position(int joint) const {
	const int joints = std::max(view.joint_count(), 1);
	if (joint < 0 || joint > joints) {
		report_error(this,
				"get_joint_position(" + String::num_int64(joint) + ") needs a joint from 0, the root, to " +
						String::num_int64(joints) + ", the tip.");
		return Vector3();
	}
	return arm(float(joint) / float(joints)) * view.height();
}

double Plant3D::get_deflection() const {
	const glm::vec3 from = rest();
	const glm::vec3 direction = motion.motion_state(rest()).now.direction;
	return std::atan2(glm::length(glm::cross(from, direction)), glm::dot(from, direction));
}

void Plant3D::apply_impulse(const Vector3 &impulse, int joint) {
	if (!impulse.is_finite()) {
		report_error(this, "apply_impulse() needs a finite impulse in newton seconds.");
		return;
	}
	if (!motion.is_simulated()) {
		if (!can_be_driven()) {
			return;
		}
		drive();
	}
	const int joints = std::max(view.joint_count(), 1);
	if (joint < 0 || joint == joints) {
		motion.apply_impulse(to_glm(impulse));
	} else if (joint > 0 && joint < joints) {
		motion.apply_impulse_at(joint, to_glm(impulse));
	} else {
		report_error(this,
				"apply_impulse() cannot reach joint " + String::num_int64(joint) + ". Use one from 1 to " +
						String::num_int64(joints) + ", or -1 for the tip.");
	}
}

void Plant3D::reset_motion() {
	motion.reset();
	bend_at_rest();
	update_bone();
	motion.pose_now(rest());
}

PackedFloat32Array Plant3D::get_motion_state() const {
	const PlantMotionState motion_state = motion.motion_state(rest());
	return plant_transform.floats_of({ motion_state.now, motion_state.second });
}

void Plant3D::set_motion_state(const PackedFloat32Array &state) {
	MotionState given;
	if (!plant_transform.read_state(state, given)) {
		report_error(this,
				"set_motion_state() needs twelve finite numbers, as returned by get_motion_state(), or the first six: "
				"the tip's direction and its rate. The motion was not changed.");
		return;
	}
	motion.set_motion_state({ given.tip, given.tip.direction, given.second });
	motion.pose_now(rest());
}

bool Plant3D::is_point_in_plants(const Vector3 &point) const {
	if (!point.is_finite() || !is_inside_tree() || species.is_null()) {
		return false;
	}
	const float length = plant_transform.length_of(view.height());
	const int parts = std::max(view.joint_count(), 1);
	const float reach = float(touch_margin + species->get_collision_radius());
	glm::vec3 from = plant_transform.root;
	for (int part = 1; part <= parts; part++) {
		const glm::vec3 to =
				plant_transform.root + length * to_glm(plant_transform.axes.xform(arm(float(part) / float(parts))));
		if (glm::distance(nearest_on_segment(from, to, to_glm(point)), to_glm(point)) <= reach) {
			return true;
		}
		from = to;
	}
	return false;
}

void Plant3D::_bind_methods() {
	ClassDB::bind_method(D_METHOD("_on_species_changed"), &Plant3D::on_species_changed);
	ClassDB::bind_method(D_METHOD("_on_wind_changed"), &Plant3D::on_wind_changed);
	ClassDB::bind_method(D_METHOD("_on_rebuild_queued"), &Plant3D::on_rebuild_queued);
	ClassDB::bind_method(D_METHOD("set_species", "species"), &Plant3D::set_species);
	ClassDB::bind_method(D_METHOD("get_species"), &Plant3D::get_species);
	ClassDB::bind_method(D_METHOD("set_wind", "wind"), &Plant3D::set_wind);
	ClassDB::bind_method(D_METHOD("get_wind"), &Plant3D::get_wind);
	ClassDB::bind_method(D_METHOD("set_segments", "segments"), &Plant3D::set_segments);
	ClassDB::bind_method(D_METHOD("get_segments"), &Plant3D::get_segments);
	ClassDB::bind_method(D_METHOD("set_height", "metres"), &Plant3D::set_height);
	ClassDB::bind_method(D_METHOD("get_height"), &Plant3D::get_height);
	ClassDB::bind_method(D_METHOD("set_seed", "seed"), &Plant3D::set_seed);
	ClassDB::bind_method(D_METHOD("get_seed"), &Plant3D::get_seed);
	ClassDB::bind_method(D_METHOD("set_simulation_enabled", "simulation_enabled"), &Plant3D::set_simulation_enabled);
	ClassDB::bind_method(D_METHOD("is_simulation_enabled"), &Plant3D::is_simulation_enabled);
	ClassDB::bind_method(D_METHOD("set_contact_enabled", "contact_enabled"), &Plant3D::set_contact_enabled);
	ClassDB::bind_method(D_METHOD("is_contact_enabled"), &Plant3D::is_contact_enabled);
	ClassDB::bind_method(D_METHOD("set_bodies_group", "bodies_group"), &Plant3D::set_bodies_group);
	ClassDB::bind_method(D_METHOD("get_bodies_group"), &Plant3D::get_bodies_group);
	ClassDB::bind_method(D_METHOD("set_apparent_wind", "share"), &Plant3D::set_apparent_wind);
	ClassDB::bind_method(D_METHOD("get_apparent_wind"), &Plant3D::get_apparent_wind);
	ClassDB::bind_method(D_METHOD("set_touch_margin", "metres"), &Plant3D::set_touch_margin);
	ClassDB::bind_method(D_METHOD("get_touch_margin"), &Plant3D::get_touch_margin);
	ClassDB::bind_method(D_METHOD("rebuild"), &Plant3D::rebuild);
	ClassDB::bind_method(D_METHOD("get_mesh"), &Plant3D::get_mesh);
	ClassDB::bind_method(D_METHOD("get_skeleton"), &Plant3D::get_skeleton);
	ClassDB::bind_method(D_METHOD("get_reach"), &Plant3D::get_reach);
	ClassDB::bind_method(D_METHOD("get_plant_height"), &Plant3D::get_plant_height);
	ClassDB::bind_method(D_METHOD("get_tip_position"), &Plant3D::get_tip_position);
	ClassDB::bind_method(D_METHOD("get_deflection"), &Plant3D::get_deflection);
	ClassDB::bind_method(D_METHOD("is_point_in_plants", "point"), &Plant3D::is_point_in_plants);
	ClassDB::bind_method(D_METHOD("apply_impulse", "impulse", "joint"), &Plant3D::apply_impulse, DEFVAL(-1));
	ClassDB::bind_method(D_METHOD("get_joint_count"), &Plant3D::get_joint_count);
	ClassDB::bind_method(D_METHOD("get_joint_position", "joint"), &Plant3D::get_joint_position);
	ClassDB::bind_method(D_METHOD("reset_motion"), &Plant3D::reset_motion);
	ClassDB::bind_method(D_METHOD("get_motion_state"), &Plant3D::get_motion_state);
	ClassDB::bind_method(D_METHOD("set_motion_state", "state"), &Plant3D::set_motion_state);
	ClassDB::bind_method(D_METHOD("advance", "delta"), &Plant3D::advance);
	ClassDB::bind_method(D_METHOD("_preview", "delta", "wind"), &Plant3D::preview);

	ADD_GROUP("Plant", "");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "species", PROPERTY_HINT_RESOURCE_TYPE, "PlantFunction"), "set_species",
			"get_species");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "height", PROPERTY_HINT_RANGE, "0,5,0.01,or_greater,suffix:m"),
			"set_height", "get_height");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "seed"), "set_seed", "get_seed");
	ADD_GROUP("Motion", "");
	ADD_PROPERTY(
			PropertyInfo(Variant::OBJECT, "wind", PROPERTY_HINT_RESOURCE_TYPE, "PlantWind"), "set_wind", "get_wind");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "simulation_enabled"), "set_simulation_enabled", "is_simulation_enabled");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "contact_enabled"), "set_contact_enabled", "is_contact_enabled");
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "bodies_group"), "set_bodies_group", "get_bodies_group");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "touch_margin", PROPERTY_HINT_RANGE, "0,2,0.01,or_greater,suffix:m"),
			"set_touch_margin", "get_touch_margin");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "apparent_wind", PROPERTY_HINT_RANGE, "0,1,0.01,or_greater"),
			"set_apparent_wind", "get_apparent_wind");
	ADD_GROUP("Drawing", "");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "segments", PROPERTY_HINT_RANGE, "1,64,1,or_greater"), "set_segments",
			"get_segments");
	ADD_SIGNAL(MethodInfo("mesh_changed"));
	const PropertyInfo body(Variant::OBJECT, "body", PROPERTY_HINT_RESOURCE_TYPE, "Node3D");
	ADD_SIGNAL(MethodInfo("body_entered_plants", body));
	ADD_SIGNAL(MethodInfo("body_exited_plants", body));
}

} // namespace undergrowth

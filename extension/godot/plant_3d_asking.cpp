// Where a Plant3D is bent to, and what pushes it there at once.

#include "plant_3d.hpp"

#include "convert.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

Vector3 Plant3D::arm(float share) const {
	glm::vec3 found;
	if (motion.find_arm(share, found)) {
		return stance.axes.xform_inv(to_godot(found));
	}
	const glm::vec3 own = to_glm(stance.axes.xform_inv(to_godot(motion.swing(rest()).now.direction)));
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
	const glm::vec3 direction = motion.swing(rest()).now.direction;
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
	motion.reset(rest());
	update_bone();
	motion.pose_now(rest());
}

PackedFloat32Array Plant3D::get_motion_state() const {
	return stance.floats_of(motion.swing(rest()).now);
}

void Plant3D::set_motion_state(const PackedFloat32Array &state) {
	TipState given;
	if (!stance.read_state(state, given)) {
		report_error(this,
				"set_motion_state() needs six finite numbers: the tip's direction and its rate, as get_motion_state() "
				"gives them. The motion stays as it is.");
		return;
	}
	motion.set_swing({ given, given.direction });
	motion.pose_now(rest());
}

bool Plant3D::is_point_in_plants(const Vector3 &point) const {
	if (!point.is_finite() || !is_inside_tree() || species.is_null()) {
		return false;
	}
	const float length = stance.length_of(view.height());
	const int parts = std::max(view.joint_count(), 1);
	const float reach = float(touch_margin + species->get_collision_radius());
	glm::vec3 from = stance.root;
	for (int part = 1; part <= parts; part++) {
		const glm::vec3 to = stance.root + length * to_glm(stance.axes.xform(arm(float(part) / float(parts))));
		if (glm::distance(nearest_on_segment(from, to, to_glm(point)), to_glm(point)) <= reach) {
			return true;
		}
		from = to;
	}
	return false;
}

} // namespace undergrowth

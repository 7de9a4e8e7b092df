#include "bodies/body_shapes.hpp"

#include "base/convert.hpp"

#include <godot_cpp/classes/area3d.hpp>
#include <godot_cpp/classes/box_shape3d.hpp>
#include <godot_cpp/classes/capsule_shape3d.hpp>
#include <godot_cpp/classes/collision_shape3d.hpp>
#include <godot_cpp/classes/cylinder_shape3d.hpp>
#include <godot_cpp/classes/sphere_shape3d.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr float MAX_ROUNDING = 0.02f; // m, of the edges of a box.
static constexpr float SIDE_OF_DISC = 0.8862269f; // Half the side of a square of the unit disc's area.

static void find_below(const Node *node, const StringName &group, std::vector<uint64_t> &found) {
	for (int i = 0; i < node->get_child_count(); i++) {
		const Node *child = node->get_child(i);
		if (Object::cast_to<CollisionShape3D>(child)) {
			found.push_back(child->get_instance_id());
		}
		if (!Object::cast_to<Area3D>(child) && !child->is_in_group(group)) {
			find_below(child, group, found);
		}
	}
}

std::vector<uint64_t> find_shape_holders(const Node3D *body, const StringName &group) {
	std::vector<uint64_t> found;
	find_below(body, group, found);
	return found;
}

static MovingBody box_body(const Vector3 &half) {
	MovingBody body;
	body.radius = std::min(MAX_ROUNDING, 0.5f * float(std::min({ half.x, half.y, half.z })));
	body.to = { half.x - body.radius, 0.0f, 0.0f };
	body.from = -body.to;
	body.half_width = { 0.0f, half.y - body.radius, 0.0f };
	body.half_depth = { 0.0f, 0.0f, half.z - body.radius };
	return body;
}

static MovingBody capsule_body(float radius, float height) {
	MovingBody body;
	body.radius = radius;
	body.to = { 0.0f, std::max(0.5f * height - radius, 0.0f), 0.0f };
	body.from = -body.to;
	return body;
}

// Returns the shape in its own axes; with radius 0 if it cannot push.
static MovingBody body_of(const Ref<Shape3D> &shape) {
	if (const BoxShape3D *box = Object::cast_to<BoxShape3D>(shape.ptr())) {
		return box_body(0.5f * box->get_size());
	}
	if (const SphereShape3D *sphere = Object::cast_to<SphereShape3D>(shape.ptr())) {
		return capsule_body(float(sphere->get_radius()), 0.0f);
	}
	if (const CapsuleShape3D *capsule = Object::cast_to<CapsuleShape3D>(shape.ptr())) {
		return capsule_body(float(capsule->get_radius()), float(capsule->get_height()));
	}
	const CylinderShape3D *cylinder = Object::cast_to<CylinderShape3D>(shape.ptr());
	if (!cylinder) {
		return capsule_body(0.0f, 0.0f);
	}
	const float radius = float(cylinder->get_radius());
	const float height = float(cylinder->get_height());
	if (height < 2.0f * radius) {
		return box_body(Vector3(SIDE_OF_DISC * radius, 0.5f * height, SIDE_OF_DISC * radius));
	}
	return capsule_body(radius, height);
}

bool may_push(const CollisionShape3D *holder) {
	return body_of(holder->get_shape()).radius > 0.0f;
}

bool shape_in_world(const CollisionShape3D *holder, MovingBody &body) {
	if (holder->is_disabled() || !holder->is_inside_tree()) {
		return false;
	}
	body = transformed(holder->get_global_transform(), body_of(holder->get_shape()));
	return is_valid(body);
}

/// Returns `half` made orthogonal to `first` and `second`, with the same length.
static glm::vec3 squared_up(const glm::vec3 &half, const glm::vec3 &first, const glm::vec3 &second) {
	glm::vec3 across = half;
	for (const glm::vec3 &other : { first, second }) {
		const float squared = glm::dot(other, other);
		across -= squared > 0.0f ? other * (glm::dot(across, other) / squared) : glm::vec3(0.0f);
	}
	const float size = glm::length(across);
	return size > 0.0f ? across * (glm::length(half) / size) : half;
}

MovingBody transformed(const Transform3D &to, const MovingBody &body) {
	MovingBody moved = body;
	moved.from = to_glm(to.xform(to_godot(body.from)));
	moved.to = to_glm(to.xform(to_godot(body.to)));
	const glm::vec3 along = moved.to - moved.from;
	moved.half_width = squared_up(to_glm(to.basis.xform(to_godot(body.half_width))), along, glm::vec3(0.0f));
	moved.half_depth = squared_up(to_glm(to.basis.xform(to_godot(body.half_depth))), along, moved.half_width);
	moved.velocity = to_glm(to.basis.xform(to_godot(body.velocity)));
	const float scale = std::sqrt(to.basis.rows[0].length() * to.basis.rows[2].length());
	moved.radius = body.radius * scale;
	moved.growth = body.growth * scale;
	return moved;
}

} // namespace undergrowth

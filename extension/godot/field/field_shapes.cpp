#include "field/field_shapes.hpp"

#include "convert.hpp"

#include <godot_cpp/classes/resource.hpp>

#include <algorithm>

using namespace godot;

namespace undergrowth {

static void add_shape(const Node3D *holder, const Transform3D &to_field, std::vector<FieldBody> &bodies) {
	const Ref<Resource> shape = holder->get("shape");
	if (shape.is_null() || bool(holder->get("disabled"))) {
		return;
	}
	const bool is_long = shape->is_class("CapsuleShape3D") || shape->is_class("CylinderShape3D");
	if (!is_long && !shape->is_class("SphereShape3D")) {
		return;
	}
	const Transform3D placed = to_field * holder->get_global_transform();
	const float radius = float(double(shape->get("radius")));
	const float height = is_long ? float(double(shape->get("height"))) : 0.0f;
	const Vector3 half(0.0f, std::max(0.5f * height - radius, 0.0f), 0.0f);
	FieldBody body;
	body.from = to_glm(placed.xform(-half));
	body.to = to_glm(placed.xform(half));
	body.radius = radius * placed.basis.get_column(0).length();
	bodies.push_back(body);
}

void add_shapes(const Node3D *body, const Transform3D &to_field, std::vector<FieldBody> &bodies) {
	for (int i = 0; i < body->get_child_count(); i++) {
		const Node3D *child = Object::cast_to<Node3D>(body->get_child(i));
		if (child && child->is_class("CollisionShape3D")) {
			add_shape(child, to_field, bodies);
		}
	}
}

} // namespace undergrowth

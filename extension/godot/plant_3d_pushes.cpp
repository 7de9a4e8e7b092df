// What moves a Plant3D besides the wind: other tips, and bodies.

#include "plant_3d.hpp"

#include "convert.hpp"

#include <glm/geometric.hpp>

using namespace godot;

namespace undergrowth {

static constexpr Range MARGIN_RANGE = { 0.0, 100.0 };

void Plant3D::set_contact_enabled(bool on) {
	contact_enabled = on;
	change_pushes();
}

bool Plant3D::is_contact_enabled() const {
	return contact_enabled;
}

void Plant3D::set_bodies_group(const StringName &group) {
	bodies_group = group;
	change_pushes();
}

StringName Plant3D::get_bodies_group() const {
	return bodies_group;
}

void Plant3D::set_touch_margin(double metres) {
	if (accept_value(this, "touch_margin", metres, MARGIN_RANGE)) {
		touch_margin = metres;
		change_pushes();
	}
}

double Plant3D::get_touch_margin() const {
	return touch_margin;
}

// Plants that the same pushes share a page.
void Plant3D::change_pushes() {
	if (place.group && !(place.group->kind.push == what_pushes())) {
		update_simulation();
	}
}

void Plant3D::forget_touches() {
	if (PlantSimulation *simulation = PlantSimulation::get_singleton()) {
		simulation->forget_touches(this);
	}
}

void Plant3D::tell_of_body(uint64_t body, bool has_entered) {
	if (Object *node = ObjectDB::get_instance(body)) {
		call_deferred("emit_signal", has_entered ? "body_entered_plants" : "body_exited_plants", node);
	}
}

bool Plant3D::is_point_in_plants(const Vector3 &point) const {
	if (!point.is_finite() || !is_inside_tree() || species.is_null()) {
		return false;
	}
	const glm::vec3 tip = root + description().length * swing().now.direction;
	const float away = glm::distance(nearest_on_segment(root, tip, to_glm(point)), to_glm(point));
	return away <= float(touch_margin + species->get_collision_radius());
}

} // namespace undergrowth

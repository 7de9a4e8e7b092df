// What users set of a PlantField3D: where plants stand, and on what.

#include "field/plant_field_3d.hpp"

#include "follow_changes.hpp"

using namespace godot;

namespace undergrowth {

static constexpr Range SIZE_RANGE = { 0.0, 1e5 };
static constexpr Range HEIGHT_LIMITS_RANGE = { -1e6, 1e6 };
static constexpr Range SLOPE_LIMITS_RANGE = { 0.0, 180.0 };
static constexpr Range SLOPE_ALIGNMENT_RANGE = { 0.0, 1.0 };

void PlantField3D::set_size(const Vector2 &metres) {
	if (accept_value(this, "size", metres.x, SIZE_RANGE) && accept_value(this, "size", metres.y, SIZE_RANGE)) {
		options.size = metres;
		mark_stale();
	}
}

Vector2 PlantField3D::get_size() const {
	return options.size;
}

void PlantField3D::set_area(const Ref<Curve3D> &curve) {
	const Callable changed(this, "_on_area_changed");
	unfollow_changes(area.ptr(), changed);
	area = curve;
	follow_changes(area.ptr(), changed);
	notify_property_list_changed();
	mark_stale();
}

Ref<Curve3D> PlantField3D::get_area() const {
	return area;
}

void PlantField3D::set_exclusions(const TypedArray<Curve3D> &curves) {
	const Callable changed(this, "_on_area_changed");
	for (int64_t i = 0; i < exclusions.size(); i++) {
		unfollow_changes(Object::cast_to<Resource>(exclusions[i]), changed);
	}
	exclusions = curves.duplicate();
	for (int64_t i = 0; i < exclusions.size(); i++) {
		follow_changes(Object::cast_to<Resource>(exclusions[i]), changed);
	}
	mark_stale();
}

TypedArray<Curve3D> PlantField3D::get_exclusions() const {
	return exclusions;
}

void PlantField3D::set_excluded_fields(const TypedArray<NodePath> &paths) {
	excluded_fields = paths;
	mark_stale();
}

TypedArray<NodePath> PlantField3D::get_excluded_fields() const {
	return excluded_fields;
}

void PlantField3D::set_ground(GroundKind kind) {
	if (kind < GROUND_NONE || kind > GROUND_MESH) {
		report_error(this, "ground " + String::num_int64(kind) + " does not exist. Use one of the GROUND_ constants.");
		return;
	}
	options.ground = int(kind);
	notify_property_list_changed();
	mark_stale();
}

PlantField3D::GroundKind PlantField3D::get_ground() const {
	return GroundKind(options.ground);
}

void PlantField3D::set_ground_mask(int64_t mask) {
	options.ground_mask = mask;
	mark_stale();
}

int64_t PlantField3D::get_ground_mask() const {
	return options.ground_mask;
}

void PlantField3D::set_ground_mesh(const NodePath &path) {
	ground_mesh = path;
	mark_stale();
}

NodePath PlantField3D::get_ground_mesh() const {
	return ground_mesh;
}

void PlantField3D::set_height_limits(const Vector2 &metres) {
	set_span(options.height_limits, "height_limits", metres, HEIGHT_LIMITS_RANGE);
}

Vector2 PlantField3D::get_height_limits() const {
	return options.height_limits;
}

void PlantField3D::set_slope_limits_degrees(const Vector2 &degrees) {
	set_span(options.slope_limits_degrees, "slope_limits_degrees", degrees, SLOPE_LIMITS_RANGE);
}

Vector2 PlantField3D::get_slope_limits_degrees() const {
	return options.slope_limits_degrees;
}

void PlantField3D::set_slope_alignment(double value) {
	set_number(options.slope_alignment, "slope_alignment", value, SLOPE_ALIGNMENT_RANGE, true);
}

double PlantField3D::get_slope_alignment() const {
	return options.slope_alignment;
}

} // namespace undergrowth

#include "species/curve_plant_function.hpp"

#include "base/follow_changes.hpp"
#include "base/shortest_decimal.hpp"
#include "plant/base_shape.hpp"

#include <godot_cpp/core/class_db.hpp>

#include <algorithm>

using namespace godot;

namespace undergrowth {

static constexpr Range RADIUS_RANGE = { 0.0001, 100.0 };
static constexpr Range LOBES_RANGE = { 2, 64 };
static constexpr Range LOBE_DEPTH_RANGE = { 0.0, 0.9 };
static constexpr Range HEIGHT_RANGE = { 0.001, 1000.0 };
// A blade of grass is about eight times wider than thick.
static constexpr float BLADE_THICKNESS = 0.25f;
static constexpr float BLADE_SKEW = 0.5f;

static std::vector<glm::vec2> make_ring(
		CurvePlantFunction::CrossSection shape, int lod, float radius, int lobes, float lobe_depth) {
	switch (shape) {
		case CurvePlantFunction::CROSS_SECTION_PARALLELOGRAM:
			return parallelogram_ring(2.0f * radius, BLADE_THICKNESS * radius, BLADE_SKEW * radius);
		case CurvePlantFunction::CROSS_SECTION_LOBED:
			return lobed_ring(lod, radius, lobes, lobe_depth);
		case CurvePlantFunction::CROSS_SECTION_CIRCLE:
			break;
	}
	return circle_ring(lod, radius);
}

PackedVector3Array CurvePlantFunction::own_base_shape(int lod) const {
	PackedVector3Array points;
	for (const glm::vec2 &point : make_ring(cross_section, lod, radius, lobes, lobe_depth)) {
		points.push_back(Vector3(point.x, 0.0f, point.y));
	}
	return points;
}

double CurvePlantFunction::own_height(const Ref<RandomNumberGenerator> &rng) const {
	return rng->randf_range(std::min(height_min, height_max), std::max(height_min, height_max));
}

double CurvePlantFunction::own_curve_point(double offset) const {
	if (width_curve.is_null() || width_curve->get_point_count() == 0) {
		return 1.0 - offset;
	}
	return std::max(0.0, double(width_curve->sample_baked(float(offset))));
}

Color CurvePlantFunction::own_color(double offset) const {
	if (color_gradient.is_null()) {
		return PlantFunction::own_color(offset);
	}
	return color_gradient->sample(float(offset));
}

template <typename Part> void CurvePlantFunction::follow(Ref<Part> &slot, const Ref<Part> &part) {
	if (part == slot) {
		return;
	}
	const Callable changed(this, "_on_part_changed");
	unfollow_changes(slot.ptr(), changed);
	slot = part;
	follow_changes(slot.ptr(), changed);
	shape_changed();
}

void CurvePlantFunction::on_part_changed() {
	shape_changed();
}

void CurvePlantFunction::set_size(float &slot, const char *property, double value, const Range &range) {
	if (accept_value(this, property, value, range) && float(value) != slot) {
		slot = float(value);
		shape_changed();
	}
}

void CurvePlantFunction::set_cross_section(CrossSection shape) {
	if (shape < CROSS_SECTION_CIRCLE || shape > CROSS_SECTION_LOBED) {
		report_error(this,
				"cross_section " + String::num_int64(shape) +
						" does not exist. Use one of the CROSS_SECTION_ constants.");
		return;
	}
	if (shape != cross_section) {
		cross_section = shape;
		notify_property_list_changed();
		shape_changed();
	}
}

CurvePlantFunction::CrossSection CurvePlantFunction::get_cross_section() const {
	return cross_section;
}

void CurvePlantFunction::set_radius(double metres) {
	set_size(radius, "radius", metres, RADIUS_RANGE);
}

double CurvePlantFunction::get_radius() const {
	return shortest_decimal(radius);
}

void CurvePlantFunction::set_lobes(int count) {
	if (accept_value(this, "lobes", count, LOBES_RANGE) && count != lobes) {
		lobes = count;
		shape_changed();
	}
}

int CurvePlantFunction::get_lobes() const {
	return lobes;
}

void CurvePlantFunction::set_lobe_depth(double depth) {
	set_size(lobe_depth, "lobe_depth", depth, LOBE_DEPTH_RANGE);
}

double CurvePlantFunction::get_lobe_depth() const {
	return shortest_decimal(lobe_depth);
}

void CurvePlantFunction::set_width_curve(const Ref<Curve> &curve) {
	follow(width_curve, curve);
}

Ref<Curve> CurvePlantFunction::get_width_curve() const {
	return width_curve;
}

void CurvePlantFunction::set_color_gradient(const Ref<Gradient> &gradient) {
	follow(color_gradient, gradient);
}

Ref<Gradient> CurvePlantFunction::get_color_gradient() const {
	return color_gradient;
}

void CurvePlantFunction::set_height_min(double metres) {
	set_size(height_min, "height_min", metres, HEIGHT_RANGE);
}

double CurvePlantFunction::get_height_min() const {
	return shortest_decimal(height_min);
}

void CurvePlantFunction::set_height_max(double metres) {
	set_size(height_max, "height_max", metres, HEIGHT_RANGE);
}

double CurvePlantFunction::get_height_max() const {
	return shortest_decimal(height_max);
}

void CurvePlantFunction::_validate_property(PropertyInfo &property) const {
	const String name = property.name;
	if (cross_section != CROSS_SECTION_LOBED && (name == "lobes" || name == "lobe_depth")) {
		property.usage = PROPERTY_USAGE_NO_EDITOR;
	}
}

void CurvePlantFunction::_bind_methods() {
	ClassDB::bind_method(D_METHOD("_on_part_changed"), &CurvePlantFunction::on_part_changed);
	ClassDB::bind_method(D_METHOD("set_cross_section", "shape"), &CurvePlantFunction::set_cross_section);
	ClassDB::bind_method(D_METHOD("get_cross_section"), &CurvePlantFunction::get_cross_section);
	ClassDB::bind_method(D_METHOD("set_radius", "metres"), &CurvePlantFunction::set_radius);
	ClassDB::bind_method(D_METHOD("get_radius"), &CurvePlantFunction::get_radius);
	ClassDB::bind_method(D_METHOD("set_lobes", "count"), &CurvePlantFunction::set_lobes);
	ClassDB::bind_method(D_METHOD("get_lobes"), &CurvePlantFunction::get_lobes);
	ClassDB::bind_method(D_METHOD("set_lobe_depth", "depth"), &CurvePlantFunction::set_lobe_depth);
	ClassDB::bind_method(D_METHOD("get_lobe_depth"), &CurvePlantFunction::get_lobe_depth);
	ClassDB::bind_method(D_METHOD("set_width_curve", "curve"), &CurvePlantFunction::set_width_curve);
	ClassDB::bind_method(D_METHOD("get_width_curve"), &CurvePlantFunction::get_width_curve);
	ClassDB::bind_method(D_METHOD("set_color_gradient", "gradient"), &CurvePlantFunction::set_color_gradient);
	ClassDB::bind_method(D_METHOD("get_color_gradient"), &CurvePlantFunction::get_color_gradient);
	ClassDB::bind_method(D_METHOD("set_height_min", "metres"), &CurvePlantFunction::set_height_min);
	ClassDB::bind_method(D_METHOD("get_height_min"), &CurvePlantFunction::get_height_min);
	ClassDB::bind_method(D_METHOD("set_height_max", "metres"), &CurvePlantFunction::set_height_max);
	ClassDB::bind_method(D_METHOD("get_height_max"), &CurvePlantFunction::get_height_max);

	ADD_GROUP("Shape", "");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "cross_section", PROPERTY_HINT_ENUM, "Circle,Parallelogram,Lobed"),
			"set_cross_section", "get_cross_section");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "radius", PROPERTY_HINT_RANGE, "0.001,1,0.001,or_greater,suffix:m"),
			"set_radius", "get_radius");
	ADD_PROPERTY(
			PropertyInfo(Variant::INT, "lobes", PROPERTY_HINT_RANGE, "2,16,1,or_greater"), "set_lobes", "get_lobes");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "lobe_depth", PROPERTY_HINT_RANGE, "0,0.9,0.01"), "set_lobe_depth",
			"get_lobe_depth");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "width_curve", PROPERTY_HINT_RESOURCE_TYPE, "Curve"), "set_width_curve",
			"get_width_curve");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "color_gradient", PROPERTY_HINT_RESOURCE_TYPE, "Gradient"),
			"set_color_gradient", "get_color_gradient");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "height_min", PROPERTY_HINT_RANGE, "0.01,5,0.01,or_greater,suffix:m"),
			"set_height_min", "get_height_min");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "height_max", PROPERTY_HINT_RANGE, "0.01,5,0.01,or_greater,suffix:m"),
			"set_height_max", "get_height_max");

	BIND_ENUM_CONSTANT(CROSS_SECTION_CIRCLE);
	BIND_ENUM_CONSTANT(CROSS_SECTION_PARALLELOGRAM);
	BIND_ENUM_CONSTANT(CROSS_SECTION_LOBED);
}

} // namespace undergrowth

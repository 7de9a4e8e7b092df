// PlantArrangement: bindings.

#include "form/plant_arrangement.hpp"

#include <godot_cpp/core/class_db.hpp>

#include <algorithm>

using namespace godot;

namespace undergrowth {

// Properties of some layouts only.
static const char *const ALONG_ONLY[] = { "from", "to", "per_node", "turn" };
static const char *const DISC_ONLY[] = { "dome", "level_tops" };

template <size_t N> static bool is_one_of(const String &name, const char *const (&names)[N]) {
	return std::any_of(names, names + N, [&](const char *other) { return name == other; });
}

void PlantArrangement::_validate_property(PropertyInfo &property) const {
	const String name = property.name;
	const Layout layout = arrangement.layout;
	const bool is_ground = layout == Layout::ground;
	const bool is_hidden = (layout != Layout::along && is_one_of(name, ALONG_ONLY)) ||
			(layout != Layout::disc && is_one_of(name, DISC_ONLY)) || (layout == Layout::along && name == "radius") ||
			(!is_ground && (name == "tilt" || name == "swept")) ||
			(is_ground && (name == "angle" || name == "angle_curve" || name == "flat"));
	if (is_hidden) {
		property.usage = PROPERTY_USAGE_NO_EDITOR;
	}
}

static PropertyInfo number(const char *name, const char *range) {
	return PropertyInfo(Variant::FLOAT, name, PROPERTY_HINT_RANGE, range);
}

static PropertyInfo span(const char *name, const char *range) {
	return PropertyInfo(Variant::VECTOR2, name, PROPERTY_HINT_RANGE, range);
}

static PropertyInfo resource(const char *name, const char *type) {
	return PropertyInfo(Variant::OBJECT, name, PROPERTY_HINT_RESOURCE_TYPE, type);
}

#define UNDERGROWTH_ADD(m_name, m_info)                                                                                \
	ClassDB::bind_method(D_METHOD("set_" #m_name, "value"), &PlantArrangement::set_##m_name);                          \
	ClassDB::bind_method(D_METHOD("get_" #m_name), &PlantArrangement::get_##m_name);                                   \
	ADD_PROPERTY(m_info, "set_" #m_name, "get_" #m_name)

void PlantArrangement::_bind_methods() {
	ClassDB::bind_static_method("PlantArrangement", D_METHOD("of", "values"), &PlantArrangement::of);
	ClassDB::bind_method(D_METHOD("_on_changed"), &PlantArrangement::on_changed);
	UNDERGROWTH_ADD(visible, PropertyInfo(Variant::BOOL, "visible"));
	UNDERGROWTH_ADD(layout, PropertyInfo(Variant::INT, "layout", PROPERTY_HINT_ENUM, "Along,Whorl,Disc,Ground"));
	UNDERGROWTH_ADD(part, resource("part", "PlantPart"));
	UNDERGROWTH_ADD(count, PropertyInfo(Variant::VECTOR2I, "count", PROPERTY_HINT_RANGE, "0,200,1,or_greater"));
	UNDERGROWTH_ADD(from, number("from", "0,1,0.001"));
	UNDERGROWTH_ADD(to, number("to", "0,1,0.001"));
	UNDERGROWTH_ADD(per_node, PropertyInfo(Variant::INT, "per_node", PROPERTY_HINT_RANGE, "1,64,1"));
	UNDERGROWTH_ADD(turn, number("turn", "-360,360,0.001,or_less,or_greater,radians_as_degrees"));
	UNDERGROWTH_ADD(phase, number("phase", "-360,360,0.1,or_less,or_greater,radians_as_degrees"));
	UNDERGROWTH_ADD(radius, number("radius", "0,1,0.0001,or_greater,suffix:m"));
	UNDERGROWTH_ADD(dome, number("dome", "0,180,0.1,radians_as_degrees"));
	UNDERGROWTH_ADD(level_tops, PropertyInfo(Variant::BOOL, "level_tops"));
	UNDERGROWTH_ADD(flat, PropertyInfo(Variant::BOOL, "flat"));
	UNDERGROWTH_ADD(tilt, span("tilt", "-180,180,0.1,or_less,or_greater,radians_as_degrees"));
	UNDERGROWTH_ADD(swept, number("swept", "0,1,0.01"));
	UNDERGROWTH_ADD(angle, span("angle", "-180,180,0.1,or_less,or_greater,radians_as_degrees"));
	UNDERGROWTH_ADD(angle_curve, resource("angle_curve", "Curve"));
	UNDERGROWTH_ADD(scale, span("scale", "0.01,4,0.001,or_less,or_greater"));
	UNDERGROWTH_ADD(scale_curve, resource("scale_curve", "Curve"));
	UNDERGROWTH_ADD(deviation, number("deviation", "0,85,0.1,radians_as_degrees"));
	UNDERGROWTH_ADD(
			carries, PropertyInfo(Variant::ARRAY, "carries", PROPERTY_HINT_ARRAY_TYPE, "24/17:PlantArrangement"));
	BIND_ENUM_CONSTANT(LAYOUT_ALONG);
	BIND_ENUM_CONSTANT(LAYOUT_WHORL);
	BIND_ENUM_CONSTANT(LAYOUT_DISC);
	BIND_ENUM_CONSTANT(LAYOUT_GROUND);
}

} // namespace undergrowth

#include "form/plant_part_kinds.hpp"

#include "base/new_object.hpp"

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

namespace undergrowth {

static constexpr Profile PROFILES[] = { GRASS_PROFILE, STRAP_PROFILE, LANCEOLATE_PROFILE, OVATE_PROFILE,
	ELLIPTIC_PROFILE, OBOVATE_PROFILE, SPATULATE_PROFILE, TEPAL_PROFILE, RAY_PROFILE, EVEN_PROFILE };

template <class Kind> static Ref<Kind> make_with(const Dictionary &values) {
	Ref<Kind> made = new_counted<Kind>();
	made->set_all(values);
	return made;
}

static PropertyInfo number(const char *name, const char *range) {
	return PropertyInfo(Variant::FLOAT, name, PROPERTY_HINT_RANGE, range);
}

// Adds a property of the class with the accessors set_NAME and get_NAME.
template <class Kind, class Set, class Get> static void add_property(const PropertyInfo &info, Set setter, Get getter) {
	const String set_name = "set_" + String(info.name);
	const String get_name = "get_" + String(info.name);
	ClassDB::bind_method(D_METHOD(StringName(set_name), "value"), setter);
	ClassDB::bind_method(D_METHOD(StringName(get_name)), getter);
	ClassDB::add_property(Kind::get_class_static(), info, StringName(set_name), StringName(get_name));
}

#define UNDERGROWTH_ADD(m_class, m_name, m_info)                                                                       \
	add_property<m_class>(m_info, &m_class::set_##m_name, &m_class::get_##m_name)

PlantAxis::PlantAxis() {
	part.kind = PartKind::axis;
	part.widths.profile = EVEN_PROFILE;
	part.length_min = part.length_max = 0.3f;
	part.width = 0.004f;
	part.axis.tip_diameter = 0.002f;
	part.frequency = 0.0f;
}

Ref<PlantAxis> PlantAxis::of(const Dictionary &values) {
	return make_with<PlantAxis>(values);
}

void PlantAxis::set_diameter(const Vector2 &metres) {
	if (!accept_value(this, "diameter", metres.x, { 1e-5, 10.0 }) ||
			!accept_value(this, "diameter", metres.y, { 0.0, 10.0 }) || metres == get_diameter()) {
		return;
	}
	part.width = metres.x;
	part.axis.tip_diameter = metres.y;
	emit_changed();
}

Vector2 PlantAxis::get_diameter() const {
	return Vector2(part.width, part.axis.tip_diameter);
}

void PlantAxis::set_open_tip(bool open) {
	if (open != part.axis.open_tip) {
		part.axis.open_tip = open;
		emit_changed();
	}
}

void PlantAxis::_bind_methods() {
	ClassDB::bind_static_method("PlantAxis", D_METHOD("of", "values"), &PlantAxis::of);
	ADD_GROUP("Shape", "");
	UNDERGROWTH_ADD(PlantAxis, diameter,
			PropertyInfo(Variant::VECTOR2, "diameter", PROPERTY_HINT_RANGE, "0,0.1,0.0001,or_greater,suffix:m"));
	UNDERGROWTH_ADD(PlantAxis, open_tip, PropertyInfo(Variant::BOOL, "open_tip"));
	UNDERGROWTH_ADD(PlantAxis, bend, number("bend", "-180,180,0.1,or_less,or_greater,radians_as_degrees"));
	UNDERGROWTH_ADD(PlantAxis, bend_power, number("bend_power", "0.5,4,0.01"));
	UNDERGROWTH_ADD(PlantAxis, wander, number("wander", "0,85,0.1,radians_as_degrees"));
	UNDERGROWTH_ADD(PlantAxis, lobes, PropertyInfo(Variant::INT, "lobes", PROPERTY_HINT_RANGE, "0,64,1"));
	UNDERGROWTH_ADD(PlantAxis, lobe_depth, number("lobe_depth", "0,0.9,0.01"));
}

PlantBlade::PlantBlade() {
	part.kind = PartKind::blade;
	part.widths.profile = LANCEOLATE_PROFILE;
	part.widths.base_width = 0.2f;
	part.translucency = 1.0f;
}

Ref<PlantBlade> PlantBlade::of(const Dictionary &values) {
	return make_with<PlantBlade>(values);
}

void PlantBlade::set_profile(BladeProfile kind) {
	if (kind < PROFILE_GRASS || kind > PROFILE_EVEN) {
		report_error(
				this, "profile " + String::num_int64(kind) + " does not exist. Use one of the PROFILE_ constants.");
	} else if (kind != profile) {
		profile = kind;
		part.widths.profile = PROFILES[int(kind)];
		emit_changed();
	}
}

void PlantBlade::_validate_property(PropertyInfo &property) const {
	const String name = property.name;
	if ((name == "tooth_depth" && part.blade.teeth == 0) || (name == "wave_count" && part.blade.wave == 0.0f)) {
		property.usage = PROPERTY_USAGE_NO_EDITOR;
	}
}

void PlantBlade::_bind_methods() {
	ClassDB::bind_static_method("PlantBlade", D_METHOD("of", "values"), &PlantBlade::of);
	ADD_GROUP("Shape", "");
	UNDERGROWTH_ADD(PlantBlade, width, number("width", "0.0005,0.2,0.0001,or_greater,suffix:m"));
	UNDERGROWTH_ADD(PlantBlade, profile,
			PropertyInfo(Variant::INT, "profile", PROPERTY_HINT_ENUM,
					"Grass,Strap,Lanceolate,Ovate,Elliptic,Obovate,Spatulate,Tepal,Ray,Even"));
	UNDERGROWTH_ADD(PlantBlade, base_width, number("base_width", "0,1,0.01"));
	UNDERGROWTH_ADD(PlantBlade, bend, number("bend", "-180,180,0.1,or_less,or_greater,radians_as_degrees"));
	UNDERGROWTH_ADD(PlantBlade, bend_power, number("bend_power", "0.5,4,0.01"));
	UNDERGROWTH_ADD(PlantBlade, wander, number("wander", "0,85,0.1,radians_as_degrees"));
	UNDERGROWTH_ADD(PlantBlade, fold, number("fold", "-85,85,0.1,radians_as_degrees"));
	UNDERGROWTH_ADD(PlantBlade, roll, number("roll", "-180,180,0.1,or_less,or_greater,radians_as_degrees"));
	UNDERGROWTH_ADD(PlantBlade, twist, number("twist", "-360,360,0.1,or_less,or_greater,radians_as_degrees"));
	UNDERGROWTH_ADD(PlantBlade, wave, number("wave", "0,1,0.01"));
	UNDERGROWTH_ADD(PlantBlade, wave_count, number("wave_count", "0,32,0.1"));
	UNDERGROWTH_ADD(PlantBlade, teeth, PropertyInfo(Variant::INT, "teeth", PROPERTY_HINT_RANGE, "0,32,1"));
	UNDERGROWTH_ADD(PlantBlade, tooth_depth, number("tooth_depth", "0,0.9,0.01"));
	UNDERGROWTH_ADD(PlantBlade, roundness, number("roundness", "0,57,0.1,radians_as_degrees"));
	BIND_ENUM_CONSTANT(PROFILE_GRASS);
	BIND_ENUM_CONSTANT(PROFILE_STRAP);
	BIND_ENUM_CONSTANT(PROFILE_LANCEOLATE);
	BIND_ENUM_CONSTANT(PROFILE_OVATE);
	BIND_ENUM_CONSTANT(PROFILE_ELLIPTIC);
	BIND_ENUM_CONSTANT(PROFILE_OBOVATE);
	BIND_ENUM_CONSTANT(PROFILE_SPATULATE);
	BIND_ENUM_CONSTANT(PROFILE_TEPAL);
	BIND_ENUM_CONSTANT(PROFILE_RAY);
	BIND_ENUM_CONSTANT(PROFILE_EVEN);
}

PlantBead::PlantBead() {
	part.kind = PartKind::bead;
	part.length_min = part.length_max = 0.005f;
	part.width = 0.002f;
	part.frequency = 0.0f;
}

Ref<PlantBead> PlantBead::of(const Dictionary &values) {
	return make_with<PlantBead>(values);
}

void PlantBead::_bind_methods() {
	ClassDB::bind_static_method("PlantBead", D_METHOD("of", "values"), &PlantBead::of);
	ADD_GROUP("Shape", "");
	UNDERGROWTH_ADD(PlantBead, diameter, number("diameter", "0.0005,0.1,0.0001,or_greater,suffix:m"));
}

} // namespace undergrowth

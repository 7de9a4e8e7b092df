// PlantFunction: bindings.

#include "species/plant_function.hpp"

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

namespace undergrowth {

static void bind_functions() {
	ClassDB::bind_method(D_METHOD("get_base_shape", "lod"), &PlantFunction::get_base_shape);
	ClassDB::bind_method(D_METHOD("generate_height", "rng"), &PlantFunction::generate_height);
	ClassDB::bind_method(D_METHOD("calculate_curve_point", "offset"), &PlantFunction::calculate_curve_point);
	ClassDB::bind_method(D_METHOD("calculate_color_at_point", "offset"), &PlantFunction::calculate_color_at_point);
	ClassDB::bind_method(
			D_METHOD("generate_mesh", "height", "segments", "seed"), &PlantFunction::generate_mesh, DEFVAL(0));
	ClassDB::bind_method(
			D_METHOD("find_problem", "height", "segments", "seed"), &PlantFunction::find_problem, DEFVAL(0));
}

static void bind_motion_methods() {
	ClassDB::bind_method(D_METHOD("set_law", "law"), &PlantFunction::set_law);
	ClassDB::bind_method(D_METHOD("get_law"), &PlantFunction::get_law);
	ClassDB::bind_method(D_METHOD("set_elasticity", "elasticity"), &PlantFunction::set_elasticity);
	ClassDB::bind_method(D_METHOD("get_elasticity"), &PlantFunction::get_elasticity);
	ClassDB::bind_method(D_METHOD("set_inner_friction", "friction"), &PlantFunction::set_inner_friction);
	ClassDB::bind_method(D_METHOD("get_inner_friction"), &PlantFunction::get_inner_friction);
	ClassDB::bind_method(D_METHOD("set_stays_above_ground", "stays"), &PlantFunction::set_stays_above_ground);
	ClassDB::bind_method(D_METHOD("get_stays_above_ground"), &PlantFunction::get_stays_above_ground);
	ClassDB::bind_method(D_METHOD("set_natural_frequency", "hertz"), &PlantFunction::set_natural_frequency);
	ClassDB::bind_method(D_METHOD("get_natural_frequency"), &PlantFunction::get_natural_frequency);
	ClassDB::bind_method(D_METHOD("set_frequency_height", "metres"), &PlantFunction::set_frequency_height);
	ClassDB::bind_method(D_METHOD("get_frequency_height"), &PlantFunction::get_frequency_height);
	ClassDB::bind_method(D_METHOD("set_frequency_deviation", "deviation"), &PlantFunction::set_frequency_deviation);
	ClassDB::bind_method(D_METHOD("get_frequency_deviation"), &PlantFunction::get_frequency_deviation);
	ClassDB::bind_method(D_METHOD("set_damping_ratio", "ratio"), &PlantFunction::set_damping_ratio);
	ClassDB::bind_method(D_METHOD("get_damping_ratio"), &PlantFunction::get_damping_ratio);
	ClassDB::bind_method(D_METHOD("set_lean", "radians"), &PlantFunction::set_lean);
	ClassDB::bind_method(D_METHOD("get_lean"), &PlantFunction::get_lean);
	ClassDB::bind_method(D_METHOD("_on_stem_changed"), &PlantFunction::on_stem_changed);
	ClassDB::bind_method(D_METHOD("set_stem", "stem"), &PlantFunction::set_stem);
	ClassDB::bind_method(D_METHOD("get_stem"), &PlantFunction::get_stem);
	ClassDB::bind_method(D_METHOD("set_mass", "kilograms"), &PlantFunction::set_mass);
	ClassDB::bind_method(D_METHOD("get_mass"), &PlantFunction::get_mass);
	ClassDB::bind_method(D_METHOD("set_wind_weight", "weight"), &PlantFunction::set_wind_weight);
	ClassDB::bind_method(D_METHOD("get_wind_weight"), &PlantFunction::get_wind_weight);
	ClassDB::bind_method(D_METHOD("set_drag_area", "square_metres"), &PlantFunction::set_drag_area);
	ClassDB::bind_method(D_METHOD("get_drag_area"), &PlantFunction::get_drag_area);
	ClassDB::bind_method(D_METHOD("set_collision_radius", "metres"), &PlantFunction::set_collision_radius);
	ClassDB::bind_method(D_METHOD("get_collision_radius"), &PlantFunction::get_collision_radius);
	ClassDB::bind_method(D_METHOD("set_trampling", "share"), &PlantFunction::set_trampling);
	ClassDB::bind_method(D_METHOD("get_trampling"), &PlantFunction::get_trampling);
	ClassDB::bind_method(D_METHOD("set_lodging_angle", "radians"), &PlantFunction::set_lodging_angle);
	ClassDB::bind_method(D_METHOD("get_lodging_angle"), &PlantFunction::get_lodging_angle);
	ClassDB::bind_method(D_METHOD("set_recovery_time", "seconds"), &PlantFunction::set_recovery_time);
	ClassDB::bind_method(D_METHOD("get_recovery_time"), &PlantFunction::get_recovery_time);
}

static void bind_mesh_methods() {
	ClassDB::bind_method(D_METHOD("_on_arrangement_changed"), &PlantFunction::on_arrangement_changed);
	ClassDB::bind_method(D_METHOD("_on_own_change"), &PlantFunction::on_own_change);
	ClassDB::bind_method(D_METHOD("_on_grown_change"), &PlantFunction::on_grown_change);
	ClassDB::bind_method(D_METHOD("set_has_stem", "grows"), &PlantFunction::set_has_stem);
	ClassDB::bind_method(D_METHOD("get_has_stem"), &PlantFunction::get_has_stem);
	ClassDB::bind_method(D_METHOD("set_arrangements", "arrangements"), &PlantFunction::set_arrangements);
	ClassDB::bind_method(D_METHOD("get_arrangements"), &PlantFunction::get_arrangements);
	ClassDB::bind_method(D_METHOD("set_shading", "shading"), &PlantFunction::set_shading);
	ClassDB::bind_method(D_METHOD("get_shading"), &PlantFunction::get_shading);
	ClassDB::bind_method(D_METHOD("set_shape_deviation", "deviation"), &PlantFunction::set_shape_deviation);
	ClassDB::bind_method(D_METHOD("get_shape_deviation"), &PlantFunction::get_shape_deviation);
	ClassDB::bind_method(D_METHOD("set_color_deviation", "deviation"), &PlantFunction::set_color_deviation);
	ClassDB::bind_method(D_METHOD("get_color_deviation"), &PlantFunction::get_color_deviation);
	ClassDB::bind_method(D_METHOD("set_material", "material"), &PlantFunction::set_material);
	ClassDB::bind_method(D_METHOD("get_material"), &PlantFunction::get_material);
}

static PropertyInfo number(const char *name, const char *range) {
	return PropertyInfo(Variant::FLOAT, name, PROPERTY_HINT_RANGE, String::utf8(range)); // For units such as N·s/m.
}

void PlantFunction::_bind_methods() {
	GDVIRTUAL_BIND(_get_base_shape, "lod");
	GDVIRTUAL_BIND(_generate_height, "rng");
	GDVIRTUAL_BIND(_calculate_curve_point, "offset");
	GDVIRTUAL_BIND(_calculate_color_at_point, "offset");
	GDVIRTUAL_BIND(_grow, "plant");
	bind_functions();
	bind_motion_methods();
	bind_mesh_methods();

	ADD_GROUP("Parts", "");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "has_stem"), "set_has_stem", "get_has_stem");
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "arrangements", PROPERTY_HINT_ARRAY_TYPE, "24/17:PlantArrangement"),
			"set_arrangements", "get_arrangements");
	ADD_GROUP("Motion", "");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "law", PROPERTY_HINT_ENUM, "Elasticity,Spring,Stem"), "set_law", "get_law");
	ADD_PROPERTY(number("elasticity", "-0.5,20,0.01,or_greater"), "set_elasticity", "get_elasticity");
	ADD_PROPERTY(
			number("inner_friction", "0,5,0.001,or_greater,suffix:N·s/m"), "set_inner_friction", "get_inner_friction");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "stays_above_ground"), "set_stays_above_ground", "get_stays_above_ground");
	ADD_PROPERTY(number("natural_frequency", "0.05,10,0.01,or_greater,suffix:Hz"), "set_natural_frequency",
			"get_natural_frequency");
	ADD_PROPERTY(
			number("frequency_height", "0,3,0.01,or_greater,suffix:m"), "set_frequency_height", "get_frequency_height");
	ADD_PROPERTY(number("frequency_deviation", "0,0.3,0.01"), "set_frequency_deviation", "get_frequency_deviation");
	ADD_PROPERTY(number("damping_ratio", "0,2,0.001,or_greater"), "set_damping_ratio", "get_damping_ratio");
	ADD_PROPERTY(number("lean", "0,80,0.1,radians_as_degrees"), "set_lean", "get_lean");
	ADD_PROPERTY(
			PropertyInfo(Variant::OBJECT, "stem", PROPERTY_HINT_RESOURCE_TYPE, "PlantStem"), "set_stem", "get_stem");
	ADD_PROPERTY(number("mass", "0.001,10,0.001,or_greater,exp,suffix:kg"), "set_mass", "get_mass");
	ADD_PROPERTY(number("wind_weight", "-1,4,0.01,or_greater"), "set_wind_weight", "get_wind_weight");
	ADD_PROPERTY(number("drag_area", "-1,1,0.0001,or_greater,suffix:m²"), "set_drag_area", "get_drag_area");
	ADD_PROPERTY(number("collision_radius", "0,1,0.001,or_greater,suffix:m"), "set_collision_radius",
			"get_collision_radius");
	ADD_PROPERTY(number("trampling", "0,1,0.01"), "set_trampling", "get_trampling");
	ADD_PROPERTY(number("lodging_angle", "0,90,1,radians_as_degrees"), "set_lodging_angle", "get_lodging_angle");
	ADD_PROPERTY(number("recovery_time", "1,7200,1,or_greater,exp,suffix:s"), "set_recovery_time", "get_recovery_time");

	ADD_GROUP("Look", "");
	ADD_PROPERTY(
			PropertyInfo(Variant::INT, "shading", PROPERTY_HINT_ENUM, "Smooth,Flat"), "set_shading", "get_shading");
	ADD_PROPERTY(number("shape_deviation", "0,1,0.01"), "set_shape_deviation", "get_shape_deviation");
	ADD_PROPERTY(number("color_deviation", "0,1,0.01"), "set_color_deviation", "get_color_deviation");
	ADD_PROPERTY(
			PropertyInfo(Variant::OBJECT, "material", PROPERTY_HINT_RESOURCE_TYPE, "BaseMaterial3D,ShaderMaterial"),
			"set_material", "get_material");

	BIND_ENUM_CONSTANT(LAW_ELASTICITY);
	BIND_ENUM_CONSTANT(LAW_SPRING);
	BIND_ENUM_CONSTANT(LAW_STEM);
	BIND_ENUM_CONSTANT(SHADING_SMOOTH);
	BIND_ENUM_CONSTANT(SHADING_FLAT);
}

} // namespace undergrowth

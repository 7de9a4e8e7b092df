// What scripts and the inspector see of PlantField3D.

#include "field/plant_field_3d.hpp"

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

namespace undergrowth {

static void bind_plant_methods() {
	ClassDB::bind_method(D_METHOD("_on_species_changed"), &PlantField3D::on_species_changed);
	ClassDB::bind_method(D_METHOD("_on_area_changed"), &PlantField3D::on_area_changed);
	ClassDB::bind_method(D_METHOD("_on_wind_changed"), &PlantField3D::on_wind_changed);
	ClassDB::bind_method(D_METHOD("_on_fill_queued"), &PlantField3D::on_fill_queued);
	ClassDB::bind_method(D_METHOD("_on_monitor_asked", "which"), &PlantField3D::monitor);
	ClassDB::bind_method(D_METHOD("fill"), &PlantField3D::fill);
	ClassDB::bind_method(D_METHOD("is_filling"), &PlantField3D::is_filling);
	ClassDB::bind_method(D_METHOD("add_plants", "transforms", "function"), &PlantField3D::add_plants);
	ClassDB::bind_method(D_METHOD("remove_in_sphere", "center", "radius"), &PlantField3D::remove_in_sphere);
	ClassDB::bind_method(D_METHOD("is_point_in_plants", "point"), &PlantField3D::is_point_in_plants);
	ClassDB::bind_method(D_METHOD("preview", "delta", "wind"), &PlantField3D::preview);
	ClassDB::bind_method(D_METHOD("reset"), &PlantField3D::reset);
	ClassDB::bind_method(
			D_METHOD("apply_impulse_in_sphere", "center", "radius", "impulse"), &PlantField3D::apply_impulse_in_sphere);
	ClassDB::bind_method(D_METHOD("get_plant_count"), &PlantField3D::get_plant_count);
	ClassDB::bind_method(D_METHOD("get_plant_transform", "index"), &PlantField3D::get_plant_transform);
	ClassDB::bind_method(D_METHOD("get_plant_function", "index"), &PlantField3D::get_plant_function);
	ClassDB::bind_method(D_METHOD("get_plant_height", "index"), &PlantField3D::get_plant_height);
	ClassDB::bind_method(D_METHOD("get_plant_seed", "index"), &PlantField3D::get_plant_seed);
	ClassDB::bind_method(D_METHOD("get_tip_position", "index"), &PlantField3D::get_tip_position);
	ClassDB::bind_method(D_METHOD("get_skeleton", "index"), &PlantField3D::get_skeleton);
	ClassDB::bind_method(D_METHOD("get_skeleton_plant", "skeleton"), &PlantField3D::get_skeleton_plant);
	ClassDB::bind_method(D_METHOD("get_skeletons"), &PlantField3D::get_skeletons);
	ClassDB::bind_method(D_METHOD("get_statistics"), &PlantField3D::get_statistics);
}

static void bind_property_methods() {
	ClassDB::bind_method(D_METHOD("set_species", "value"), &PlantField3D::set_species);
	ClassDB::bind_method(D_METHOD("get_species"), &PlantField3D::get_species);
	ClassDB::bind_method(D_METHOD("set_shares", "value"), &PlantField3D::set_shares);
	ClassDB::bind_method(D_METHOD("get_shares"), &PlantField3D::get_shares);
	ClassDB::bind_method(D_METHOD("set_density", "value"), &PlantField3D::set_density);
	ClassDB::bind_method(D_METHOD("get_density"), &PlantField3D::get_density);
	ClassDB::bind_method(D_METHOD("set_seed", "value"), &PlantField3D::set_seed);
	ClassDB::bind_method(D_METHOD("get_seed"), &PlantField3D::get_seed);
	ClassDB::bind_method(D_METHOD("set_clumping", "value"), &PlantField3D::set_clumping);
	ClassDB::bind_method(D_METHOD("get_clumping"), &PlantField3D::get_clumping);
	ClassDB::bind_method(D_METHOD("set_drift_size", "value"), &PlantField3D::set_drift_size);
	ClassDB::bind_method(D_METHOD("get_drift_size"), &PlantField3D::get_drift_size);
	ClassDB::bind_method(D_METHOD("set_variants", "value"), &PlantField3D::set_variants);
	ClassDB::bind_method(D_METHOD("get_variants"), &PlantField3D::get_variants);
	ClassDB::bind_method(D_METHOD("set_scale_range", "value"), &PlantField3D::set_scale_range);
	ClassDB::bind_method(D_METHOD("get_scale_range"), &PlantField3D::get_scale_range);
	ClassDB::bind_method(D_METHOD("set_height_deviation", "value"), &PlantField3D::set_height_deviation);
	ClassDB::bind_method(D_METHOD("get_height_deviation"), &PlantField3D::get_height_deviation);
	ClassDB::bind_method(D_METHOD("set_lean_deviation_degrees", "value"), &PlantField3D::set_lean_deviation_degrees);
	ClassDB::bind_method(D_METHOD("get_lean_deviation_degrees"), &PlantField3D::get_lean_deviation_degrees);
	ClassDB::bind_method(D_METHOD("set_size", "value"), &PlantField3D::set_size);
	ClassDB::bind_method(D_METHOD("get_size"), &PlantField3D::get_size);
	ClassDB::bind_method(D_METHOD("set_area", "value"), &PlantField3D::set_area);
	ClassDB::bind_method(D_METHOD("get_area"), &PlantField3D::get_area);
	ClassDB::bind_method(D_METHOD("set_exclusions", "value"), &PlantField3D::set_exclusions);
	ClassDB::bind_method(D_METHOD("get_exclusions"), &PlantField3D::get_exclusions);
	ClassDB::bind_method(D_METHOD("set_excluded_fields", "value"), &PlantField3D::set_excluded_fields);
	ClassDB::bind_method(D_METHOD("get_excluded_fields"), &PlantField3D::get_excluded_fields);
	ClassDB::bind_method(D_METHOD("set_ground", "value"), &PlantField3D::set_ground);
	ClassDB::bind_method(D_METHOD("get_ground"), &PlantField3D::get_ground);
	ClassDB::bind_method(D_METHOD("set_ground_mask", "value"), &PlantField3D::set_ground_mask);
	ClassDB::bind_method(D_METHOD("get_ground_mask"), &PlantField3D::get_ground_mask);
	ClassDB::bind_method(D_METHOD("set_ground_mesh", "value"), &PlantField3D::set_ground_mesh);
	ClassDB::bind_method(D_METHOD("get_ground_mesh"), &PlantField3D::get_ground_mesh);
	ClassDB::bind_method(D_METHOD("set_height_limits", "value"), &PlantField3D::set_height_limits);
	ClassDB::bind_method(D_METHOD("get_height_limits"), &PlantField3D::get_height_limits);
	ClassDB::bind_method(D_METHOD("set_slope_limits_degrees", "value"), &PlantField3D::set_slope_limits_degrees);
	ClassDB::bind_method(D_METHOD("get_slope_limits_degrees"), &PlantField3D::get_slope_limits_degrees);
	ClassDB::bind_method(D_METHOD("set_slope_alignment", "value"), &PlantField3D::set_slope_alignment);
	ClassDB::bind_method(D_METHOD("get_slope_alignment"), &PlantField3D::get_slope_alignment);
	ClassDB::bind_method(D_METHOD("set_wind", "value"), &PlantField3D::set_wind);
	ClassDB::bind_method(D_METHOD("get_wind"), &PlantField3D::get_wind);
	ClassDB::bind_method(D_METHOD("set_wind_speed", "value"), &PlantField3D::set_wind_speed);
	ClassDB::bind_method(D_METHOD("get_wind_speed"), &PlantField3D::get_wind_speed);
	ClassDB::bind_method(D_METHOD("set_simulating", "value"), &PlantField3D::set_simulating);
	ClassDB::bind_method(D_METHOD("is_simulating"), &PlantField3D::is_simulating);
	ClassDB::bind_method(D_METHOD("set_threads", "value"), &PlantField3D::set_threads);
	ClassDB::bind_method(D_METHOD("get_threads"), &PlantField3D::get_threads);
	ClassDB::bind_method(D_METHOD("set_update_interval", "value"), &PlantField3D::set_update_interval);
	ClassDB::bind_method(D_METHOD("get_update_interval"), &PlantField3D::get_update_interval);
	ClassDB::bind_method(D_METHOD("set_far_distance", "value"), &PlantField3D::set_far_distance);
	ClassDB::bind_method(D_METHOD("get_far_distance"), &PlantField3D::get_far_distance);
	ClassDB::bind_method(D_METHOD("set_prototypes", "value"), &PlantField3D::set_prototypes);
	ClassDB::bind_method(D_METHOD("get_prototypes"), &PlantField3D::get_prototypes);
	ClassDB::bind_method(D_METHOD("set_contact", "value"), &PlantField3D::set_contact);
	ClassDB::bind_method(D_METHOD("has_contact"), &PlantField3D::has_contact);
	ClassDB::bind_method(D_METHOD("set_bodies_group", "value"), &PlantField3D::set_bodies_group);
	ClassDB::bind_method(D_METHOD("get_bodies_group"), &PlantField3D::get_bodies_group);
	ClassDB::bind_method(D_METHOD("set_touch_margin", "value"), &PlantField3D::set_touch_margin);
	ClassDB::bind_method(D_METHOD("get_touch_margin"), &PlantField3D::get_touch_margin);
	ClassDB::bind_method(D_METHOD("set_levels", "value"), &PlantField3D::set_levels);
	ClassDB::bind_method(D_METHOD("get_levels"), &PlantField3D::get_levels);
	ClassDB::bind_method(D_METHOD("set_level_distances", "value"), &PlantField3D::set_level_distances);
	ClassDB::bind_method(D_METHOD("get_level_distances"), &PlantField3D::get_level_distances);
	ClassDB::bind_method(D_METHOD("set_fade_margin", "value"), &PlantField3D::set_fade_margin);
	ClassDB::bind_method(D_METHOD("get_fade_margin"), &PlantField3D::get_fade_margin);
	ClassDB::bind_method(D_METHOD("set_shadow_distance", "value"), &PlantField3D::set_shadow_distance);
	ClassDB::bind_method(D_METHOD("get_shadow_distance"), &PlantField3D::get_shadow_distance);
	ClassDB::bind_method(D_METHOD("set_visibility_range", "value"), &PlantField3D::set_visibility_range);
	ClassDB::bind_method(D_METHOD("get_visibility_range"), &PlantField3D::get_visibility_range);
	ClassDB::bind_method(D_METHOD("set_skeleton_distance", "value"), &PlantField3D::set_skeleton_distance);
	ClassDB::bind_method(D_METHOD("get_skeleton_distance"), &PlantField3D::get_skeleton_distance);
	ClassDB::bind_method(D_METHOD("set_most_skeletons", "value"), &PlantField3D::set_most_skeletons);
	ClassDB::bind_method(D_METHOD("get_most_skeletons"), &PlantField3D::get_most_skeletons);
	ClassDB::bind_method(D_METHOD("set_chunk_size", "value"), &PlantField3D::set_chunk_size);
	ClassDB::bind_method(D_METHOD("get_chunk_size"), &PlantField3D::get_chunk_size);
	ClassDB::bind_method(D_METHOD("set_layers", "value"), &PlantField3D::set_layers);
	ClassDB::bind_method(D_METHOD("get_layers"), &PlantField3D::get_layers);
}

void PlantField3D::_bind_methods() {
	bind_plant_methods();
	bind_property_methods();

	ADD_GROUP("Plants", "");
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "species", PROPERTY_HINT_ARRAY_TYPE, "24/17:PlantFunction"),
			"set_species", "get_species");
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_FLOAT32_ARRAY, "shares"), "set_shares", "get_shares");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "density", PROPERTY_HINT_RANGE,
						 String::utf8("0,50,0.01,or_greater,suffix:1/m²")),
			"set_density", "get_density");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "seed"), "set_seed", "get_seed");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "clumping", PROPERTY_HINT_RANGE, "0,1,0.01"), "set_clumping", "get_clumping");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "drift_size", PROPERTY_HINT_RANGE, "0.1,50,0.1,or_greater,suffix:m"),
			"set_drift_size", "get_drift_size");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "variants", PROPERTY_HINT_RANGE, "1,64,1"), "set_variants", "get_variants");
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR2, "scale_range"), "set_scale_range", "get_scale_range");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "height_deviation", PROPERTY_HINT_RANGE, "0,0.9,0.01"),
			"set_height_deviation", "get_height_deviation");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "lean_deviation_degrees", PROPERTY_HINT_RANGE,
						 String::utf8("0,80,0.1,suffix:°")),
			"set_lean_deviation_degrees", "get_lean_deviation_degrees");
	ADD_GROUP("Area", "");
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR2, "size", PROPERTY_HINT_NONE, "suffix:m"), "set_size", "get_size");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "area", PROPERTY_HINT_RESOURCE_TYPE, "Curve3D"), "set_area", "get_area");
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "exclusions", PROPERTY_HINT_ARRAY_TYPE, "24/17:Curve3D"),
			"set_exclusions", "get_exclusions");
	ADD_PROPERTY(PropertyInfo(Variant::ARRAY, "excluded_fields", PROPERTY_HINT_ARRAY_TYPE, "22/26:PlantField3D"),
			"set_excluded_fields", "get_excluded_fields");
	ADD_GROUP("Ground", "");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "ground", PROPERTY_HINT_ENUM, "None,Colliders,Mesh"), "set_ground",
			"get_ground");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "ground_mask", PROPERTY_HINT_LAYERS_3D_PHYSICS, ""), "set_ground_mask",
			"get_ground_mask");
	ADD_PROPERTY(PropertyInfo(Variant::NODE_PATH, "ground_mesh", PROPERTY_HINT_NODE_PATH_VALID_TYPES, "MeshInstance3D"),
			"set_ground_mesh", "get_ground_mesh");
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR2, "height_limits", PROPERTY_HINT_NONE, "suffix:m"), "set_height_limits",
			"get_height_limits");
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR2, "slope_limits_degrees", PROPERTY_HINT_NONE, String::utf8("suffix:°")),
			"set_slope_limits_degrees", "get_slope_limits_degrees");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "slope_alignment", PROPERTY_HINT_RANGE, "0,1,0.01"),
			"set_slope_alignment", "get_slope_alignment");
	ADD_GROUP("Motion", "");
	ADD_PROPERTY(
			PropertyInfo(Variant::OBJECT, "wind", PROPERTY_HINT_RESOURCE_TYPE, "PlantWind"), "set_wind", "get_wind");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "wind_speed", PROPERTY_HINT_RANGE, "0,50,0.1,or_greater,suffix:m/s"),
			"set_wind_speed", "get_wind_speed");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "simulating"), "set_simulating", "is_simulating");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "threads", PROPERTY_HINT_RANGE, "0,16,1,or_greater"), "set_threads",
			"get_threads");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "update_interval", PROPERTY_HINT_RANGE, "1,64,1"), "set_update_interval",
			"get_update_interval");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "far_distance", PROPERTY_HINT_RANGE, "0,200,0.1,or_greater,suffix:m"),
			"set_far_distance", "get_far_distance");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "prototypes", PROPERTY_HINT_RANGE, "0,64,1"), "set_prototypes",
			"get_prototypes");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "contact"), "set_contact", "has_contact");
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "bodies_group"), "set_bodies_group", "get_bodies_group");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "touch_margin", PROPERTY_HINT_RANGE, "0,2,0.01,or_greater,suffix:m"),
			"set_touch_margin", "get_touch_margin");
	ADD_GROUP("Drawing", "");
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_INT32_ARRAY, "levels"), "set_levels", "get_levels");
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_FLOAT32_ARRAY, "level_distances"), "set_level_distances",
			"get_level_distances");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "fade_margin", PROPERTY_HINT_RANGE, "0,20,0.1,or_greater,suffix:m"),
			"set_fade_margin", "get_fade_margin");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "shadow_distance", PROPERTY_HINT_RANGE, "0,200,0.1,or_greater,suffix:m"),
			"set_shadow_distance", "get_shadow_distance");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "visibility_range", PROPERTY_HINT_RANGE, "0,1000,0.1,or_greater,suffix:m"),
			"set_visibility_range", "get_visibility_range");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "skeleton_distance", PROPERTY_HINT_RANGE, "0,20,0.1,or_greater,suffix:m"),
			"set_skeleton_distance", "get_skeleton_distance");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "most_skeletons", PROPERTY_HINT_RANGE, "0,1024,1"), "set_most_skeletons",
			"get_most_skeletons");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "chunk_size", PROPERTY_HINT_RANGE, "4,100,0.1,or_greater,suffix:m"),
			"set_chunk_size", "get_chunk_size");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "layers", PROPERTY_HINT_LAYERS_3D_RENDER, ""), "set_layers", "get_layers");

	ADD_SIGNAL(MethodInfo("filling_progressed", PropertyInfo(Variant::FLOAT, "share")));
	ADD_SIGNAL(MethodInfo("filled"));
	ADD_SIGNAL(MethodInfo(
			"body_entered_plants", PropertyInfo(Variant::OBJECT, "body", PROPERTY_HINT_RESOURCE_TYPE, "Node3D")));
	ADD_SIGNAL(MethodInfo(
			"body_exited_plants", PropertyInfo(Variant::OBJECT, "body", PROPERTY_HINT_RESOURCE_TYPE, "Node3D")));

	const PropertyInfo skeleton(Variant::OBJECT, "skeleton", PROPERTY_HINT_RESOURCE_TYPE, "Skeleton3D");
	ADD_SIGNAL(MethodInfo("skeleton_shown", skeleton));
	ADD_SIGNAL(MethodInfo("skeleton_hidden", skeleton));

	BIND_ENUM_CONSTANT(GROUND_NONE);
	BIND_ENUM_CONSTANT(GROUND_COLLIDERS);
	BIND_ENUM_CONSTANT(GROUND_MESH);
}

} // namespace undergrowth

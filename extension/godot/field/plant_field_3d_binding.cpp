// What PlantField3D tells of itself: how scripts and the inspector see it, statistics, the engine's monitors.

#include "field/plant_field_3d.hpp"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/performance.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <algorithm>

using namespace godot;

namespace undergrowth {

// All fields in the tree, for the monitors. Main thread only.
static std::vector<PlantField3D *> &standing_fields() {
	static std::vector<PlantField3D *> fields;
	return fields;
}

enum Monitor { MONITOR_PLANTS, MONITOR_SIMULATED, MONITOR_STEP, MONITOR_UPLOAD, MONITORS };
static const char *const MONITOR_NAMES[MONITORS] = { "undergrowth/field_plants", "undergrowth/field_simulated",
	"undergrowth/field_step_usec", "undergrowth/field_upload_usec" };

double PlantField3D::monitor(int which) const {
	double sum = 0.0;
	for (const PlantField3D *field : standing_fields()) {
		sum += which == MONITOR_PLANTS ? field->get_plant_count() : 0.0;
		sum += which == MONITOR_SIMULATED ? field->meadow.motion.simulated_count() : 0;
		sum += which == MONITOR_STEP ? field->meadow.motion.busy_usec() : 0.0;
		sum += which == MONITOR_UPLOAD ? field->meadow.upload_usec : 0.0;
	}
	return sum;
}

// The first field in the tree answers for all.
void PlantField3D::count_in_monitors(bool on) {
	std::vector<PlantField3D *> &fields = standing_fields();
	if (on) {
		fields.push_back(this);
	} else {
		fields.erase(std::remove(fields.begin(), fields.end(), this), fields.end());
	}
	Performance *performance = Performance::get_singleton();
	for (int i = 0; i < MONITORS; i++) {
		if (performance->has_custom_monitor(MONITOR_NAMES[i])) {
			performance->remove_custom_monitor(MONITOR_NAMES[i]);
		}
		if (!fields.empty()) {
			Array arguments;
			arguments.push_back(i);
			performance->add_custom_monitor(MONITOR_NAMES[i], Callable(fields[0], "_on_monitor_asked"), arguments);
		}
	}
}

Dictionary PlantField3D::get_statistics() {
	meadow.motion.wait();
	const Camera3D *camera = is_inside_tree() ? get_viewport()->get_camera_3d() : nullptr;
	PackedInt32Array drawn;
	for (const int count : meadow.count_drawn(camera ? camera->get_global_position() : get_position())) {
		drawn.push_back(count);
	}
	const int count = get_plant_count();
	Dictionary told;
	told["plants"] = count;
	told["simulated"] = meadow.motion.simulated_count();
	told["drawn_by_level"] = drawn;
	told["is_dressing"] = (meadow.is_at_work() && !meadow.is_filling()) || (look_is_stale && fill_is_queued);
	told["skeletons"] = int64_t(meadow.skeletons.count());
	told["step_usec"] = meadow.motion.busy_usec();
	told["upload_usec"] = meadow.upload_usec;
	told["main_usec"] = main_usec;
	told["wait_usec"] = wait_usec;
	told["bytes_per_plant"] = count > 0 ? double(meadow.store.bytes()) / count + meadow.motion.bytes_per_plant() : 0.0;
	return told;
}

// The inspector shows what counts for this ground and area, and hides what the engine's base classes say of one mesh.
// (Properties with a slider stay: a new list would end the dragging of it.)
void PlantField3D::_validate_property(PropertyInfo &property) const {
	static const char *const of_one_mesh[] = { "gi_mode", "gi_lightmap_texel_density", "gi_lightmap_texel_scale",
		"gi_lightmap_scale", "lod_bias", "material_overlay", "extra_cull_margin", "custom_aabb",
		"ignore_occlusion_culling", "visibility_range_begin", "visibility_range_begin_margin",
		"visibility_range_end_margin", "visibility_range_fade_mode", "sorting_offset", "sorting_use_aabb_center" };
	const String name = property.name;
	const StandOptions &stand = properties.stand;
	const bool is_flat = stand.ground_mode == GROUND_NONE;
	const bool is_idle = (name == "size" && !stand.outline.is_empty()) ||
			(name == "ground_collision_mask" && stand.ground_mode != GROUND_COLLIDERS) ||
			(name == "ground_mesh" && stand.ground_mode != GROUND_MESH) ||
			(is_flat && (name == "height_limits" || name.begins_with("slope_")));
	if (is_idle || std::any_of(std::begin(of_one_mesh), std::end(of_one_mesh), [&](const char *other) {
			return name == other;
		})) {
		property.usage &= ~uint32_t(PROPERTY_USAGE_EDITOR);
	}
}

#define BIND(m_name, ...) ClassDB::bind_method(D_METHOD(#m_name, ##__VA_ARGS__), &PlantField3D::m_name)
#define LISTEN(m_name, ...) ClassDB::bind_method(D_METHOD("_" #m_name, ##__VA_ARGS__), &PlantField3D::m_name)
// A property with its setter and getter, and what else PropertyInfo says of it.
#define PROPERTY_AS(m_getter, m_type, m_name, ...)                                                                     \
	ClassDB::bind_method(D_METHOD("set_" #m_name, "value"), &PlantField3D::set_##m_name);                              \
	ClassDB::bind_method(D_METHOD(#m_getter), &PlantField3D::m_getter);                                                \
	ADD_PROPERTY(PropertyInfo(Variant::m_type, #m_name, ##__VA_ARGS__), "set_" #m_name, #m_getter)
#define PROPERTY(m_type, m_name, ...) PROPERTY_AS(get_##m_name, m_type, m_name, ##__VA_ARGS__)
#define RANGE(m_text) PROPERTY_HINT_RANGE, String::utf8(m_text)

static void bind_plants() {
	ClassDB::bind_static_method("PlantField3D", D_METHOD("from_species", "functions", "shares"),
			&PlantField3D::from_species, DEFVAL(PackedFloat32Array()));
	LISTEN(on_species_changed);
	LISTEN(on_added_species_changed);
	LISTEN(on_levels_changed);
	LISTEN(on_area_changed);
	LISTEN(on_wind_changed);
	LISTEN(on_fill_queued);
	LISTEN(on_tree_frame);
	LISTEN(on_physics_frame);
	ClassDB::bind_method(D_METHOD("_on_monitor_asked", "which"), &PlantField3D::monitor);
	LISTEN(preview, "delta", "wind");
	BIND(fill);
	BIND(is_filling);
	BIND(add_plants, "transforms", "species");
	BIND(remove_plant, "id");
	BIND(remove_plants, "ids");
	BIND(remove_in_sphere, "center", "radius");
	BIND(get_plant_count);
	BIND(get_plant_ids);
	BIND(has_plant, "id");
	BIND(find_plants_in_box, "box");
	BIND(find_plants_in_sphere, "center", "radius");
	BIND(get_plant_transform, "id");
	BIND(get_plant_species, "id");
	BIND(get_plant_height, "id");
	BIND(get_plant_seed, "id");
	BIND(get_plant_transforms, "ids");
	BIND(get_plant_heights, "ids");
	BIND(get_outline_points);
	BIND(is_point_in_plants, "point");
	BIND(apply_impulse_in_sphere, "center", "radius", "impulse");
	BIND(get_tip_position, "id");
	BIND(get_tip_positions, "ids");
	BIND(get_motion_state, "ids");
	BIND(set_motion_state, "ids", "state");
	BIND(reset_motion);
	BIND(get_skeleton, "id");
	BIND(get_skeleton_plant, "skeleton");
	BIND(get_skeletons);
	BIND(get_statistics);
}

void PlantField3D::_bind_methods() {
	bind_plants();
	ADD_GROUP("Plants", "");
	PROPERTY(ARRAY, species, PROPERTY_HINT_ARRAY_TYPE, "24/17:PlantFieldSpecies");
	PROPERTY(FLOAT, density, RANGE("0,100,0.01,or_greater,suffix:1/m²"));
	PROPERTY(INT, seed);
	PROPERTY(FLOAT, clumping, RANGE("0,1,0.01"));
	PROPERTY(FLOAT, clump_size, RANGE("0.1,50,0.1,or_greater,suffix:m"));
	ADD_GROUP("Area", "");
	PROPERTY(VECTOR2, size, PROPERTY_HINT_NONE, "suffix:m");
	PROPERTY(NODE_PATH, outline, PROPERTY_HINT_NODE_PATH_VALID_TYPES, "Path3D");
	PROPERTY(ARRAY, exclusions, PROPERTY_HINT_ARRAY_TYPE, "22/35:Path3D,PlantField3D");
	ADD_GROUP("Ground", "");
	PROPERTY(INT, ground_mode, PROPERTY_HINT_ENUM, "None,Colliders,Mesh");
	PROPERTY(INT, ground_collision_mask, PROPERTY_HINT_LAYERS_3D_PHYSICS);
	PROPERTY(NODE_PATH, ground_mesh, PROPERTY_HINT_NODE_PATH_VALID_TYPES, "MeshInstance3D");
	PROPERTY(VECTOR2, height_limits, PROPERTY_HINT_NONE, "suffix:m");
	PROPERTY(VECTOR2, slope_limits, RANGE("0,180,0.1,radians_as_degrees"));
	PROPERTY(FLOAT, slope_alignment, RANGE("0,1,0.01"));
	ADD_GROUP("Motion", "");
	PROPERTY(OBJECT, wind, PROPERTY_HINT_RESOURCE_TYPE, "PlantWind");
	PROPERTY_AS(is_simulation_enabled, BOOL, simulation_enabled);
	PROPERTY(INT, max_threads, RANGE("0,16,1,or_greater"));
	PROPERTY(INT, update_interval, RANGE("1,64,1"));
	PROPERTY(FLOAT, far_distance, RANGE("0,200,0.1,or_greater,suffix:m"));
	PROPERTY(INT, prototypes, RANGE("0,64,1"));
	PROPERTY_AS(is_contact_enabled, BOOL, contact_enabled);
	PROPERTY(STRING_NAME, bodies_group);
	PROPERTY(FLOAT, touch_margin, RANGE("0,2,0.01,or_greater,suffix:m"));
	ADD_GROUP("Drawing", "");
	PROPERTY(ARRAY, levels, PROPERTY_HINT_ARRAY_TYPE, "24/17:PlantFieldLevel");
	PROPERTY(FLOAT, fade_margin, RANGE("0,20,0.1,or_greater,suffix:m"));
	PROPERTY(FLOAT, shadow_distance, RANGE("0,200,0.1,or_greater,suffix:m"));
	PROPERTY(FLOAT, skeleton_distance, RANGE("0,20,0.1,or_greater,suffix:m"));
	PROPERTY(INT, max_skeletons, RANGE("0,1024,1"));
	PROPERTY(FLOAT, tile_size, RANGE("4,100,0.1,or_greater,suffix:m"));
	ADD_SIGNAL(MethodInfo("fill_progressed", PropertyInfo(Variant::FLOAT, "ratio")));
	ADD_SIGNAL(MethodInfo("filled"));
	const PropertyInfo body(Variant::OBJECT, "body", PROPERTY_HINT_RESOURCE_TYPE, "Node3D");
	ADD_SIGNAL(MethodInfo("body_entered_plants", body));
	ADD_SIGNAL(MethodInfo("body_exited_plants", body));
	const PropertyInfo skeleton(Variant::OBJECT, "skeleton", PROPERTY_HINT_RESOURCE_TYPE, "Skeleton3D");
	ADD_SIGNAL(MethodInfo("skeleton_shown", skeleton));
	ADD_SIGNAL(MethodInfo("skeleton_hidden", skeleton));
	BIND_ENUM_CONSTANT(GROUND_NONE);
	BIND_ENUM_CONSTANT(GROUND_COLLIDERS);
	BIND_ENUM_CONSTANT(GROUND_MESH);
}

} // namespace undergrowth

// The properties of PlantField3D, and their binding for scripts and the inspector.

#include "nodes/plant_field_3d.hpp"

#include "base/bind_properties.hpp"
#include "base/follow_changes.hpp"
#include "field/field_inspector.hpp"

#include <limits>
#include <type_traits>

using namespace godot;

namespace undergrowth {

void PlantField3D::changed(About about) {
	if (about == About::meshes && runtime.needs_other_tiles()) {
		about = About::placement;
	}
	const bool needs_meshes = about == About::meshes || (about == About::levels && !runtime.update_levels());
	if (about == About::placement) {
		dirty.mark_placement();
	}
	if (needs_meshes) {
		dirty.mark_style();
	}
	if (about == About::area) {
		on_area_changed();
	}
	if (about == About::skeletons) {
		runtime.skeletons_changed();
	}
	update_configuration_warnings();
}

template <auto slot, const PlantField3D::Setting &setting> void PlantField3D::set(decltype(value_of(slot)) value) {
	using Value = decltype(value);
	bool is_accepted = true;
	if constexpr (std::is_arithmetic_v<Value>) {
		is_accepted = accept_value(this, setting.name, double(value), setting.range);
	} else if constexpr (std::is_same_v<Value, Vector2>) {
		const auto accept = setting.is_angle ? accept_angle_span : accept_span;
		is_accepted = accept(this, setting.name, properties.*slot, value, setting.range);
	}
	if (is_accepted && value != properties.*slot) {
		properties.*slot = value;
		changed(setting.about);
	}
}

// A property that is only a value: the effect of a change, its bounds, and its PropertyInfo.
#define NUMBER(m_type, m_name, m_about, m_min, m_max, ...)                                                             \
	{                                                                                                                  \
		static constexpr Setting setting = { #m_name, About::m_about, { m_min, m_max } };                              \
		BIND_PROPERTY(m_type, m_name, "get_" #m_name, (&self_type::set<&FieldProperties::m_name, setting>),            \
				&self_type::get<&FieldProperties::m_name>, ##__VA_ARGS__);                                             \
	}
// The same for a span of angles, with bounds in degrees.
#define ANGLES(m_name, m_about, m_min, m_max, ...)                                                                     \
	{                                                                                                                  \
		static constexpr Setting setting = { #m_name, About::m_about, { m_min, m_max }, true };                        \
		BIND_PROPERTY(VECTOR2, m_name, "get_" #m_name, (&self_type::set<&FieldProperties::m_name, setting>),           \
				&self_type::get<&FieldProperties::m_name>, ##__VA_ARGS__);                                             \
	}
// The same without bounds.
#define VALUE(m_type, m_name, m_about, ...)                                                                            \
	NUMBER(m_type, m_name, m_about, std::numeric_limits<double>::lowest(),                                             \
			std::numeric_limits<double>::max(), ##__VA_ARGS__)
// A property with its own setter, or with a getter of another name.
#define SET_HERE(m_type, m_name, m_getter_name, ...)                                                                   \
	BIND_PROPERTY(m_type, m_name, m_getter_name, &self_type::set_##m_name,                                             \
			&self_type::get<&FieldProperties::m_name>, ##__VA_ARGS__)

void PlantField3D::bind_properties() {
	ADD_GROUP("Plants", "");
	PROPERTY(ARRAY, species, PROPERTY_HINT_ARRAY_TYPE, "24/17:PlantFieldSpecies");
	NUMBER(FLOAT, density, placement, 0.0, 10000.0, SLIDER("0,100,0.01,or_greater,suffix:1/m²"));
	VALUE(INT, seed, placement);
	NUMBER(FLOAT, clumping, placement, 0.0, 1.0, SLIDER("0,1,0.01"));
	NUMBER(FLOAT, clump_size, placement, 0.01, 1000.0, SLIDER("0.1,50,0.1,or_greater,suffix:m"));
	NUMBER(FLOAT, combed, placement, 0.0, 1.0, SLIDER("0,1,0.01"));
	ADD_GROUP("Area", "");
	SET_HERE(VECTOR2, size, "get_size", PROPERTY_HINT_NONE, "suffix:m");
	SET_HERE(NODE_PATH, outline, "get_outline", PROPERTY_HINT_NODE_PATH_VALID_TYPES, "Path3D");
	NUMBER(FLOAT, outline_width, area, 0.0, 1000.0, SLIDER("0,20,0.01,or_greater,suffix:m"));
	SET_HERE(OBJECT, map, "get_map", PROPERTY_HINT_RESOURCE_TYPE, "PlantMap");
	SET_HERE(ARRAY, exclusions, "get_exclusions", PROPERTY_HINT_ARRAY_TYPE, "22/35:Path3D,PlantField3D");
	SET_HERE(PACKED_FLOAT32_ARRAY, exclusion_widths, "get_exclusion_widths", PROPERTY_HINT_NONE, "suffix:m");
	SET_HERE(FLOAT, view_distance, "get_view_distance", SLIDER("0,500,1,or_greater,suffix:m"));
	SET_HERE(BOOL, endless, "is_endless");
	VALUE(ARRAY, streaming_targets, nothing, PROPERTY_HINT_ARRAY_TYPE, "22/35:Node3D");
	ADD_GROUP("Ground", "");
	PROPERTY(INT, ground_mode, PROPERTY_HINT_ENUM, "None,Colliders,Mesh,Object");
	PROPERTY(INT, ground_choice, PROPERTY_HINT_ENUM, "Highest,Lowest");
	VALUE(INT, ground_collision_mask, placement, PROPERTY_HINT_LAYERS_3D_PHYSICS);
	VALUE(NODE_PATH, ground_mesh, placement, PROPERTY_HINT_NODE_PATH_VALID_TYPES, "MeshInstance3D");
	VALUE(NODE_PATH, ground_object, placement);
	NUMBER(FLOAT, ground_sample_spacing, placement, 0.0, 100.0, SLIDER("0,4,0.01,or_greater,suffix:m"));
	NUMBER(VECTOR2, height_limits, placement, -1e6, 1e6, PROPERTY_HINT_NONE, "suffix:m");
	ANGLES(slope_limits, placement, 0.0, 180.0, SLIDER("0,180,0.1,radians_as_degrees"));
	NUMBER(FLOAT, slope_alignment, placement, 0.0, 1.0, SLIDER("0,1,0.01"));
	ADD_GROUP("Motion", "");
	SET_HERE(OBJECT, wind, "get_wind", PROPERTY_HINT_RESOURCE_TYPE, "PlantWind");
	NUMBER(FLOAT, apparent_wind, nothing, 0.0, 10.0, SLIDER("0,1,0.01,or_greater"));
	SET_HERE(BOOL, simulation_enabled, "is_simulation_enabled");
	NUMBER(INT, max_threads, nothing, 0.0, 256.0, SLIDER("0,16,1,or_greater"));
	SET_HERE(INT, update_interval, "get_update_interval", SLIDER("1,64,1"));
	NUMBER(FLOAT, far_distance, nothing, 0.0, 1e6, SLIDER("0,200,0.1,or_greater,suffix:m"));
	NUMBER(INT, prototypes, meshes, 0.0, 64.0, SLIDER("0,64,1"));
	SET_HERE(BOOL, contact_enabled, "is_contact_enabled");
	VALUE(STRING_NAME, bodies_group, nothing);
	NUMBER(FLOAT, touch_margin, nothing, 0.0, 100.0, SLIDER("0,2,0.01,or_greater,suffix:m"));
	NUMBER(FLOAT, regrowth_rate, nothing, 0.0, 1000.0, SLIDER("0,1,0.001,or_greater,suffix:1/s"));
	ADD_GROUP("Drawing", "");
	SET_HERE(ARRAY, levels, "get_levels", PROPERTY_HINT_ARRAY_TYPE, "24/17:PlantFieldLevel");
	NUMBER(FLOAT, pixel_error, levels, 0.0, 100.0, SLIDER("0,16,0.1,or_greater,suffix:px"));
	NUMBER(FLOAT, fade_ratio, levels, 0.0, 1.0, SLIDER("0,1,0.01"));
	NUMBER(FLOAT, shadow_distance, levels, 0.0, 1e6, SLIDER("0,200,0.1,or_greater,suffix:m"));
	NUMBER(FLOAT, skeleton_distance, skeletons, 0.0, 1e6, SLIDER("0,20,0.1,or_greater,suffix:m"));
	NUMBER(INT, max_skeletons, skeletons, 0.0, 1024.0, SLIDER("0,1024,1"));
	NUMBER(FLOAT, tile_size, meshes, 1.0, 1000.0, SLIDER("4,100,0.1,or_greater,suffix:m"));
	ADD_GROUP("Building", "");
	NUMBER(FLOAT, build_budget_msec, nothing, 0.1, 1000.0, SLIDER("0.1,16,0.1,or_greater,suffix:ms"));
	// After the properties that decide the ids of plants.
	PROPERTY(PACKED_BYTE_ARRAY, saved_changes, PROPERTY_HINT_NONE, "", PROPERTY_USAGE_STORAGE);
}

void PlantField3D::_validate_property(PropertyInfo &property) const {
	if (!shows_in_inspector(property.name, properties)) {
		property.usage &= ~uint32_t(PROPERTY_USAGE_EDITOR);
	}
}

void PlantField3D::set_contact_enabled(bool on) {
	properties.contact_enabled = on;
	update_configuration_warnings();
	runtime.motion.fit_contact(on);
}

void PlantField3D::set_simulation_enabled(bool on) {
	properties.simulation_enabled = on;
	if (!on) {
		runtime.refresh(); // Draws the result of the last step.
	}
}

void PlantField3D::set_update_interval(int step_count) {
	if (accept_value(this, "update_interval", step_count, { 1, 64 })) {
		properties.update_interval = step_count;
		runtime.motion.set_update_interval(step_count);
	}
}

void PlantField3D::set_wind(const Ref<PlantWind> &wind) {
	const Callable listener(this, "_on_wind_changed");
	unfollow_changes(properties.wind.ptr(), listener);
	properties.wind = wind;
	follow_changes(properties.wind.ptr(), listener);
	update_configuration_warnings();
}

void PlantField3D::set_size(const Vector2 &metres) {
	static constexpr Range SIZE_RANGE = { 0.0, 1e5 };
	if (accept_value(this, "size", metres.x, SIZE_RANGE) && accept_value(this, "size", metres.y, SIZE_RANGE) &&
			metres != properties.size) {
		properties.size = metres;
		dirty.mark_placement();
		update_gizmos();
	}
}

void PlantField3D::set_outline(const NodePath &path) {
	if (path == properties.outline) {
		return;
	}
	properties.outline = path;
	notify_property_list_changed();
	dirty.mark_placement();
	update_gizmos();
}

void PlantField3D::set_map(const Ref<PlantMap> &painted) {
	if (painted == properties.map) {
		return;
	}
	const Callable listener(this, "_on_map_painted");
	if (properties.map.is_valid()) {
		follow_signal(properties.map.ptr(), "area_changed", listener, false);
	}
	properties.map = painted;
	if (painted.is_valid()) {
		follow_signal(properties.map.ptr(), "area_changed", listener);
	}
	notify_property_list_changed();
	dirty.mark_placement();
	update_gizmos();
	update_configuration_warnings();
}

void PlantField3D::set_view_distance(double metres) {
	if (accept_value(this, "view_distance", metres, { 0.0, 1e4 }) && metres != properties.view_distance) {
		const bool is_other_kind = (metres > 0.0) != runtime.streams();
		properties.view_distance = metres;
		if (is_other_kind) {
			dirty.mark_placement();
		}
		update_configuration_warnings();
	}
}

void PlantField3D::set_endless(bool on) {
	if (on == properties.endless) {
		return;
	}
	properties.endless = on;
	notify_property_list_changed();
	dirty.mark_placement();
	update_gizmos();
}

// Scripts may also have appended to the array, so it may differ from the stored one.
void PlantField3D::set_exclusions(const TypedArray<NodePath> &paths) {
	properties.exclusions = paths.duplicate();
	if (dependencies.has_other_exclusions(properties)) {
		dependencies.store_exclusions(properties);
		dirty.mark_placement();
	}
}

void PlantField3D::set_exclusion_widths(const PackedFloat32Array &metres) {
	static constexpr Range WIDTH_RANGE = { 0.0, 1000.0 };
	bool are_accepted = true;
	for (int64_t i = 0; i < metres.size() && are_accepted; i++) {
		are_accepted = accept_value(this, "exclusion_widths", metres[i], WIDTH_RANGE);
	}
	if (are_accepted && metres != properties.exclusion_widths) {
		properties.exclusion_widths = metres;
		on_area_changed();
	}
}

void PlantField3D::set_ground_mode(GroundMode mode) {
	if (mode < GROUND_NONE || mode > GROUND_OBJECT) {
		report_error(
				this, "ground_mode " + String::num_int64(mode) + " does not exist. Use one of the GROUND_ constants.");
	} else if (int(mode) != properties.ground_mode) {
		properties.ground_mode = int(mode);
		notify_property_list_changed();
		dirty.mark_placement();
	}
}

void PlantField3D::set_ground_choice(GroundHeight choice) {
	if (choice != GROUND_HIGHEST && choice != GROUND_LOWEST) {
		report_error(this, "ground_choice must be GROUND_HIGHEST or GROUND_LOWEST; the old value stays.");
	} else if (int(choice) != properties.ground_choice) {
		properties.ground_choice = int(choice);
		dirty.mark_placement();
	}
}

void PlantField3D::set_species(const TypedArray<PlantFieldSpecies> &entries) {
	if (species.set(entries)) {
		dirty.mark_placement();
		update_configuration_warnings();
	}
}

void PlantField3D::set_levels(const TypedArray<PlantFieldLevel> &entries) {
	properties.levels = entries.duplicate();
	followed_levels.follow(properties.levels, Callable(this, "_on_levels_changed"));
	on_levels_changed();
}

} // namespace undergrowth

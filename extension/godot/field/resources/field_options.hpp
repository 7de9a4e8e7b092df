#pragma once

#include "field/resources/plant_field_level.hpp"
#include "field/resources/plant_field_species.hpp"
#include "field/resources/plant_map.hpp"
#include "wind/plant_wind.hpp"

#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/vector2.hpp>

#include <cstdint>

namespace undergrowth {

/// The `seed` of fields that derive one from their position.
inline constexpr int64_t PLACE_SEED = -1;

/// Properties of a PlantField3D that decide which plants exist. A change of one builds the field again.
struct PlacementOptions {
	godot::TypedArray<PlantFieldSpecies> species;
	double density = 40.0; // Plants/m².
	godot::Vector2 size = { 20.0f, 20.0f }; // m.
	int64_t seed = 0; // PLACE_SEED: derived from the node's position, for the placement.
	int64_t place_seed = 0; // The seed in use, chosen when the field is built. Not set by users.
	double clumping = 0.0;
	double clump_size = 3.0; // m.
	double combed = 0.6;
	double competition = 0.0;
	int ground_mode = 0;
	int ground_choice = 0;
	int64_t ground_collision_mask = 1;
	double ground_sample_spacing = 0.5; // m; 0: a query for each plant.
	godot::Vector2 height_limits = { -1000.0f, 1000.0f }; // m.
	godot::Vector2 slope_limits = { 0.0f, 1.5707963f }; // rad.
	double slope_alignment = 0.0;
	double sun_latitude = 0.87266463; // rad, of the light of habitats: 50°.
	godot::NodePath outline; // Of a Path3D; empty: a rectangle of `size`.
	double outline_width = 0.0; // m; 0: the area inside of the path.
	double edge_falloff = 0.0; // m.
	godot::TypedArray<godot::NodePath> exclusions; // Of Path3Ds and PlantField3Ds.
	godot::PackedFloat32Array exclusion_widths; // m, by entry, as outline_width; missing ones are 0.
	godot::NodePath ground_mesh;
	godot::NodePath ground_object; // Path of a node, or of a node's property, with get_height().
	godot::Ref<PlantMap> map; // Null: full density everywhere.
	double view_distance = 0.0; // m; 0: builds the whole area.
	bool endless = false;
	godot::TypedArray<godot::NodePath> streaming_targets; // Of Node3Ds.
};

/// Properties of the motion.
struct MotionOptions {
	godot::Ref<PlantWind> wind;
	bool simulation_enabled = true;
	int max_threads = 0;
	int update_interval = 1;
	double far_distance = 25.0; // m.
	int prototypes = 0;
	bool contact_enabled = false;
	godot::StringName bodies_group;
	double touch_margin = 0.1; // m.
	double apparent_wind = 1.0; // Fraction of the node's own motion that acts as wind.
	double regrowth_rate = 0.0; // Of a plant's full height, per second.
};

/// Properties of the view.
struct ViewOptions {
	godot::TypedArray<PlantFieldLevel> levels; // Empty: default levels.
	double pixel_error = 0.0; // 0: by the project's threshold for meshes.
	double fade_ratio = 0.25; // Of the distance of a transition.
	double shadow_distance = 30.0; // m.
	double skeleton_distance = 0.0; // m.
	int max_skeletons = 64;
	double tile_size = 16.0; // m.
};

/// Properties of builds.
struct BuildOptions {
	double build_budget_msec = 1.5; // Of the main thread, per frame.
};

/// All properties of a PlantField3D that it does not inherit.
struct FieldProperties : PlacementOptions, MotionOptions, ViewOptions, BuildOptions {};

} // namespace undergrowth

#pragma once

#include "field/plant_field_level.hpp"
#include "field/plant_field_species.hpp"
#include "field/plant_map.hpp"
#include "plant_wind.hpp"

#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/vector2.hpp>

#include <cstdint>

namespace undergrowth {

/// The `seed` of fields that take one from their place.
inline constexpr int64_t PLACE_SEED = -1;

/// What users set of a PlantField3D that decides what stands: a change of it grows the field anew.
struct StandOptions {
	godot::TypedArray<PlantFieldSpecies> species;
	double density = 40.0; // Plants/m².
	godot::Vector2 size = { 20.0f, 20.0f }; // m.
	int64_t seed = 0; // PLACE_SEED: one of the node's place, for where plants grow.
	int64_t place_seed = 0; // Of `seed`, chosen when the field is built. Not set by users.
	double clumping = 0.0;
	double clump_size = 3.0; // m.
	int ground_mode = 0;
	int ground_choice = 0;
	int64_t ground_collision_mask = 1;
	double ground_sample_spacing = 0.5; // m; 0: a query for each plant.
	godot::Vector2 height_limits = { -1000.0f, 1000.0f }; // m.
	godot::Vector2 slope_limits = { 0.0f, 1.5707963f }; // rad.
	double slope_alignment = 0.0;
	godot::NodePath outline; // Of a Path3D; empty: a rectangle of `size`.
	double outline_width = 0.0; // m; 0: what the path goes around.
	godot::TypedArray<godot::NodePath> exclusions; // Of Path3Ds and PlantField3Ds.
	godot::PackedFloat32Array exclusion_widths; // m, by entry, as outline_width; missing ones are 0.
	godot::NodePath ground_mesh;
	godot::NodePath ground_object; // Of a node, or of one's property, that answers get_height().
	godot::Ref<PlantMap> map; // Null: the whole area is full.
	double view_distance = 0.0; // m; 0: the whole area stands.
	bool endless = false;
	godot::TypedArray<godot::NodePath> streaming_targets; // Of Node3Ds.
};

/// What decides how it moves.
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
	double apparent_wind = 1.0; // How much of the node's own motion is felt as wind.
	double regrowth_rate = 0.0; // Of a plant's own height, a second.
};

/// What decides how it is seen.
struct ViewOptions {
	godot::TypedArray<PlantFieldLevel> levels; // None: as usual.
	double fade_margin = 3.0; // m.
	double shadow_distance = 30.0; // m.
	double skeleton_distance = 0.0; // m.
	int max_skeletons = 64;
	double tile_size = 16.0; // m.
};

/// How fast it is built.
struct BuildOptions {
	double build_budget_msec = 1.5; // Of the main thread, a frame.
};

/// All that users set of a PlantField3D, but for what it inherits.
struct FieldProperties : StandOptions, MotionOptions, ViewOptions, BuildOptions {};

} // namespace undergrowth

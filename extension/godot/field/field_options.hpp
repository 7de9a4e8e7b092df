#pragma once

#include "field/field_ground.hpp"
#include "plant_function.hpp"
#include "plant_wind.hpp"

#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/vector2.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// A species of a field, read from its resource.
struct ListedSpecies {
	godot::Ref<PlantFunction> function;
	float share = 1.0f;
	float density_factor = 1.0f;
	godot::Vector2 scale_range = { 0.8f, 1.2f };
	float height_deviation = 0.1f;
	float lean_deviation = 0.0f; // rad.
	int variants = 4;
};

/// A level of detail of a field, read from its resource.
struct ListedLevel {
	int segments = 12;
	float end = 0.0f; // m; 0: never.
};

/// What users set of a PlantField3D that decides what stands: a change of it grows the field anew.
struct StandOptions {
	double density = 40.0; // Plants/m².
	godot::Vector2 size = { 20.0f, 20.0f }; // m.
	int64_t seed = 0;
	double clumping = 0.0;
	double clump_size = 3.0; // m.
	int ground_mode = 0;
	int64_t ground_collision_mask = 1;
	godot::Vector2 height_limits = { -1000.0f, 1000.0f }; // m.
	godot::Vector2 slope_limits = { 0.0f, 1.5707963f }; // rad.
	double slope_alignment = 0.0;
};

/// What decides how it moves.
struct MotionOptions {
	bool simulation_enabled = true;
	int max_threads = 0;
	int update_interval = 1;
	double far_distance = 25.0; // m.
	int prototypes = 0;
	bool contact_enabled = false;
	godot::StringName bodies_group;
	double touch_margin = 0.1; // m.
};

/// What decides how it is seen.
struct ViewOptions {
	double fade_margin = 3.0; // m.
	double shadow_distance = 30.0; // m.
	double skeleton_distance = 0.0; // m.
	int max_skeletons = 64;
	double tile_size = 16.0; // m.
};

} // namespace undergrowth

#pragma once

#include <godot_cpp/variant/vector2.hpp>

#include <cstdint>

namespace undergrowth {

/// What users set of a PlantField3D that is a number; in the order of the inspector.
struct FieldOptions {
	double density = 4.0; // Plants/m².
	godot::Vector2 size = { 20.0f, 20.0f }; // m.
	int64_t seed = 0;
	double clumping = 0.0;
	double drift_size = 3.0; // m.
	int variants = 4;
	godot::Vector2 scale_range = { 0.8f, 1.2f };
	double height_deviation = 0.1;
	double lean_deviation_degrees = 0.0;
	int ground = 0;
	int64_t ground_mask = 1;
	godot::Vector2 height_limits = { -1000.0f, 1000.0f }; // m.
	godot::Vector2 slope_limits_degrees = { 0.0f, 90.0f };
	double slope_alignment = 0.0;
	double wind_speed = 10.0; // m/s.
	bool simulating = true;
	int threads = 0;
	int update_interval = 1;
	double far_distance = 25.0; // m.
	int prototypes = 0;
	bool contact = false;
	double touch_margin = 0.1; // m.
	double fade_margin = 3.0; // m.
	double shadow_distance = 30.0; // m.
	double visibility_range = 0.0; // m.
	double skeleton_distance = 0.0; // m.
	int most_skeletons = 64;
	double chunk_size = 16.0; // m.
	int64_t layers = 1;
};

} // namespace undergrowth

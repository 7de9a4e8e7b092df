#pragma once

#include <godot_cpp/variant/color.hpp>
#include <godot_cpp/variant/quaternion.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cmath>

namespace undergrowth {

// Meshes are written directly to the engine's arrays, so the core's vectors have the same layout.
static_assert(sizeof(godot::Vector3) == sizeof(glm::vec3), "build the engine and the add-on with single precision");
static_assert(sizeof(godot::Color) == sizeof(glm::vec4), "a colour is four floats on both sides");

inline glm::vec3 to_glm(const godot::Vector3 &v) {
	return { v.x, v.y, v.z };
}

inline glm::vec4 to_glm(const godot::Color &c) {
	return { c.r, c.g, c.b, c.a };
}

inline godot::Vector3 to_godot(const glm::vec3 &v) {
	return godot::Vector3(v.x, v.y, v.z);
}

inline godot::Color to_godot(const glm::vec4 &c) {
	return godot::Color(c.r, c.g, c.b, c.a);
}

/// Returns the shortest rotation from upright to the direction with the stereographic image `bend`
/// (motion/bend_encoding.hpp).
inline godot::Quaternion quaternion_of(const glm::vec2 &bend) {
	const float scale = 1.0f / std::sqrt(1.0f + bend.x * bend.x + bend.y * bend.y);
	return godot::Quaternion(bend.y * scale, 0.0f, -bend.x * scale, scale);
}

} // namespace undergrowth

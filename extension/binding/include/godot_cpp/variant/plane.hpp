#pragma once

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

class Variant;

class Plane {
public:
	Vector3 normal;
	real_t d = 0;

	constexpr Plane() = default;
	constexpr Plane(const Vector3 &p_normal, real_t p_d = 0) : normal(p_normal), d(p_d) {}
	constexpr Plane(real_t p_a, real_t p_b, real_t p_c, real_t p_d) : normal(p_a, p_b, p_c), d(p_d) {}

	constexpr real_t distance_to(const Vector3 &p_point) const { return normal.dot(p_point) - d; }
	constexpr bool operator==(const Plane &p_plane) const { return normal == p_plane.normal && d == p_plane.d; }
	constexpr bool operator!=(const Plane &p_plane) const { return !(*this == p_plane); }

#include <godot_cpp/generated/plane_methods.inc>
};

} // namespace godot

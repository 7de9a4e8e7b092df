#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

class Vector3i {
public:
	enum Axis {
		AXIS_X,
		AXIS_Y,
		AXIS_Z,
	};

	int32_t x = 0;
	int32_t y = 0;
	int32_t z = 0;

	constexpr Vector3i() = default;
	constexpr Vector3i(int32_t p_x, int32_t p_y, int32_t p_z) : x(p_x), y(p_y), z(p_z) {}
	constexpr explicit Vector3i(const Vector3 &p_v) : x(int32_t(p_v.x)), y(int32_t(p_v.y)), z(int32_t(p_v.z)) {}
	constexpr operator Vector3() const { return Vector3(real_t(x), real_t(y), real_t(z)); }

	constexpr int32_t &operator[](int p_axis) { return p_axis == 0 ? x : (p_axis == 1 ? y : z); }
	constexpr const int32_t &operator[](int p_axis) const { return p_axis == 0 ? x : (p_axis == 1 ? y : z); }
	constexpr Vector3i operator+(const Vector3i &p_v) const { return Vector3i(x + p_v.x, y + p_v.y, z + p_v.z); }
	constexpr Vector3i operator-(const Vector3i &p_v) const { return Vector3i(x - p_v.x, y - p_v.y, z - p_v.z); }
	constexpr Vector3i operator*(const Vector3i &p_v) const { return Vector3i(x * p_v.x, y * p_v.y, z * p_v.z); }
	constexpr Vector3i operator/(const Vector3i &p_v) const { return Vector3i(x / p_v.x, y / p_v.y, z / p_v.z); }
	constexpr Vector3i operator*(int32_t p_s) const { return Vector3i(x * p_s, y * p_s, z * p_s); }
	constexpr Vector3i operator/(int32_t p_s) const { return Vector3i(x / p_s, y / p_s, z / p_s); }
	constexpr Vector3i &operator+=(const Vector3i &p_v) { return *this = *this + p_v; }
	constexpr Vector3i &operator-=(const Vector3i &p_v) { return *this = *this - p_v; }
	constexpr Vector3i &operator*=(const Vector3i &p_v) { return *this = *this * p_v; }
	constexpr Vector3i &operator/=(const Vector3i &p_v) { return *this = *this / p_v; }
	constexpr Vector3i &operator*=(int32_t p_s) { return *this = *this * p_s; }
	constexpr Vector3i &operator/=(int32_t p_s) { return *this = *this / p_s; }
	constexpr Vector3i operator-() const { return Vector3i(-x, -y, -z); }
	constexpr bool operator==(const Vector3i &p_v) const { return x == p_v.x && y == p_v.y && z == p_v.z; }
	constexpr bool operator!=(const Vector3i &p_v) const { return !(*this == p_v); }
	constexpr bool operator<(const Vector3i &p_v) const {
		return x != p_v.x ? x < p_v.x : y != p_v.y ? y < p_v.y : z < p_v.z;
	}

#include <godot_cpp/generated/vector3i_methods.inc>
};

constexpr Vector3i operator*(int32_t p_s, const Vector3i &p_v) {
	return p_v * p_s;
}

} // namespace godot

#pragma once

#include <godot_cpp/core/math.hpp>

namespace godot {

class Vector3i;

class Vector3 {
public:
	enum Axis {
		AXIS_X,
		AXIS_Y,
		AXIS_Z,
	};

	real_t x = 0;
	real_t y = 0;
	real_t z = 0;

	constexpr Vector3() = default;
	constexpr Vector3(real_t p_x, real_t p_y, real_t p_z) : x(p_x), y(p_y), z(p_z) {}

	constexpr real_t &operator[](int p_axis) { return p_axis == 0 ? x : (p_axis == 1 ? y : z); }
	constexpr const real_t &operator[](int p_axis) const { return p_axis == 0 ? x : (p_axis == 1 ? y : z); }
	constexpr Vector3 operator+(const Vector3 &p_v) const { return Vector3(x + p_v.x, y + p_v.y, z + p_v.z); }
	constexpr Vector3 operator-(const Vector3 &p_v) const { return Vector3(x - p_v.x, y - p_v.y, z - p_v.z); }
	constexpr Vector3 operator*(const Vector3 &p_v) const { return Vector3(x * p_v.x, y * p_v.y, z * p_v.z); }
	constexpr Vector3 operator/(const Vector3 &p_v) const { return Vector3(x / p_v.x, y / p_v.y, z / p_v.z); }
	constexpr Vector3 operator*(real_t p_s) const { return Vector3(x * p_s, y * p_s, z * p_s); }
	constexpr Vector3 operator/(real_t p_s) const { return Vector3(x / p_s, y / p_s, z / p_s); }
	constexpr Vector3 &operator+=(const Vector3 &p_v) { return *this = *this + p_v; }
	constexpr Vector3 &operator-=(const Vector3 &p_v) { return *this = *this - p_v; }
	constexpr Vector3 &operator*=(const Vector3 &p_v) { return *this = *this * p_v; }
	constexpr Vector3 &operator/=(const Vector3 &p_v) { return *this = *this / p_v; }
	constexpr Vector3 &operator*=(real_t p_s) { return *this = *this * p_s; }
	constexpr Vector3 &operator/=(real_t p_s) { return *this = *this / p_s; }
	constexpr Vector3 operator-() const { return Vector3(-x, -y, -z); }
	constexpr bool operator==(const Vector3 &p_v) const { return x == p_v.x && y == p_v.y && z == p_v.z; }
	constexpr bool operator!=(const Vector3 &p_v) const { return !(*this == p_v); }
	constexpr bool operator<(const Vector3 &p_v) const {
		return x != p_v.x ? x < p_v.x : y != p_v.y ? y < p_v.y : z < p_v.z;
	}

	constexpr real_t dot(const Vector3 &p_v) const { return x * p_v.x + y * p_v.y + z * p_v.z; }
	constexpr real_t length_squared() const { return dot(*this); }
	real_t length() const { return std::sqrt(length_squared()); }
	Vector3 normalized() const {
		const real_t l = length_squared();
		return l == 0 ? Vector3() : *this / std::sqrt(l);
	}
	void normalize() { *this = normalized(); }
	real_t distance_to(const Vector3 &p_to) const { return (p_to - *this).length(); }
	constexpr Vector3 lerp(const Vector3 &p_to, real_t p_weight) const { return *this + (p_to - *this) * p_weight; }
	bool is_finite() const { return std::isfinite(x) && std::isfinite(y) && std::isfinite(z); }
	bool is_equal_approx(const Vector3 &p_v) const {
		return Math::is_equal_approx(x, p_v.x) && Math::is_equal_approx(y, p_v.y) && Math::is_equal_approx(z, p_v.z);
	}
	bool is_zero_approx() const {
		return Math::is_zero_approx(x) && Math::is_zero_approx(y) && Math::is_zero_approx(z);
	}
	constexpr Vector3 cross(const Vector3 &p_v) const {
		return Vector3(y * p_v.z - z * p_v.y, z * p_v.x - x * p_v.z, x * p_v.y - y * p_v.x);
	}

#include <godot_cpp/generated/vector3_methods.inc>
};

constexpr Vector3 operator*(real_t p_s, const Vector3 &p_v) {
	return p_v * p_s;
}

} // namespace godot

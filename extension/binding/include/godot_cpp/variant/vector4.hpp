#pragma once

#include <godot_cpp/core/math.hpp>

namespace godot {

class Vector4i;

class Vector4 {
public:
	enum Axis {
		AXIS_X,
		AXIS_Y,
		AXIS_Z,
		AXIS_W,
	};

	real_t x = 0;
	real_t y = 0;
	real_t z = 0;
	real_t w = 0;

	constexpr Vector4() = default;
	constexpr Vector4(real_t p_x, real_t p_y, real_t p_z, real_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}

	constexpr real_t &operator[](int p_axis) { return p_axis == 0 ? x : (p_axis == 1 ? y : (p_axis == 2 ? z : w)); }
	constexpr const real_t &operator[](int p_axis) const {
		return p_axis == 0 ? x : (p_axis == 1 ? y : (p_axis == 2 ? z : w));
	}
	constexpr Vector4 operator+(const Vector4 &p_v) const {
		return Vector4(x + p_v.x, y + p_v.y, z + p_v.z, w + p_v.w);
	}
	constexpr Vector4 operator-(const Vector4 &p_v) const {
		return Vector4(x - p_v.x, y - p_v.y, z - p_v.z, w - p_v.w);
	}
	constexpr Vector4 operator*(const Vector4 &p_v) const {
		return Vector4(x * p_v.x, y * p_v.y, z * p_v.z, w * p_v.w);
	}
	constexpr Vector4 operator/(const Vector4 &p_v) const {
		return Vector4(x / p_v.x, y / p_v.y, z / p_v.z, w / p_v.w);
	}
	constexpr Vector4 operator*(real_t p_s) const { return Vector4(x * p_s, y * p_s, z * p_s, w * p_s); }
	constexpr Vector4 operator/(real_t p_s) const { return Vector4(x / p_s, y / p_s, z / p_s, w / p_s); }
	constexpr Vector4 &operator+=(const Vector4 &p_v) { return *this = *this + p_v; }
	constexpr Vector4 &operator-=(const Vector4 &p_v) { return *this = *this - p_v; }
	constexpr Vector4 &operator*=(const Vector4 &p_v) { return *this = *this * p_v; }
	constexpr Vector4 &operator/=(const Vector4 &p_v) { return *this = *this / p_v; }
	constexpr Vector4 &operator*=(real_t p_s) { return *this = *this * p_s; }
	constexpr Vector4 &operator/=(real_t p_s) { return *this = *this / p_s; }
	constexpr Vector4 operator-() const { return Vector4(-x, -y, -z, -w); }
	constexpr bool operator==(const Vector4 &p_v) const { return x == p_v.x && y == p_v.y && z == p_v.z && w == p_v.w; }
	constexpr bool operator!=(const Vector4 &p_v) const { return !(*this == p_v); }
	constexpr bool operator<(const Vector4 &p_v) const {
		return x != p_v.x ? x < p_v.x : y != p_v.y ? y < p_v.y : z != p_v.z ? z < p_v.z : w < p_v.w;
	}

	constexpr real_t dot(const Vector4 &p_v) const { return x * p_v.x + y * p_v.y + z * p_v.z + w * p_v.w; }
	constexpr real_t length_squared() const { return dot(*this); }
	real_t length() const { return std::sqrt(length_squared()); }
	Vector4 normalized() const {
		const real_t l = length_squared();
		return l == 0 ? Vector4() : *this / std::sqrt(l);
	}
	void normalize() { *this = normalized(); }
	real_t distance_to(const Vector4 &p_to) const { return (p_to - *this).length(); }
	constexpr Vector4 lerp(const Vector4 &p_to, real_t p_weight) const { return *this + (p_to - *this) * p_weight; }
	bool is_finite() const { return std::isfinite(x) && std::isfinite(y) && std::isfinite(z) && std::isfinite(w); }
	bool is_equal_approx(const Vector4 &p_v) const {
		return Math::is_equal_approx(x, p_v.x) && Math::is_equal_approx(y, p_v.y) && Math::is_equal_approx(z, p_v.z) &&
				Math::is_equal_approx(w, p_v.w);
	}
	bool is_zero_approx() const {
		return Math::is_zero_approx(x) && Math::is_zero_approx(y) && Math::is_zero_approx(z) && Math::is_zero_approx(w);
	}

#include <godot_cpp/generated/vector4_methods.inc>
};

constexpr Vector4 operator*(real_t p_s, const Vector4 &p_v) {
	return p_v * p_s;
}

} // namespace godot

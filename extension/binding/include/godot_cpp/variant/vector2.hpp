#pragma once

#include <godot_cpp/core/math.hpp>

namespace godot {

class Vector2i;

class Vector2 {
public:
	enum Axis {
		AXIS_X,
		AXIS_Y,
	};

	real_t x = 0;
	real_t y = 0;

	constexpr Vector2() = default;
	constexpr Vector2(real_t p_x, real_t p_y) : x(p_x), y(p_y) {}

	constexpr real_t &operator[](int p_axis) { return p_axis == 0 ? x : y; }
	constexpr const real_t &operator[](int p_axis) const { return p_axis == 0 ? x : y; }
	constexpr Vector2 operator+(const Vector2 &p_v) const { return Vector2(x + p_v.x, y + p_v.y); }
	constexpr Vector2 operator-(const Vector2 &p_v) const { return Vector2(x - p_v.x, y - p_v.y); }
	constexpr Vector2 operator*(const Vector2 &p_v) const { return Vector2(x * p_v.x, y * p_v.y); }
	constexpr Vector2 operator/(const Vector2 &p_v) const { return Vector2(x / p_v.x, y / p_v.y); }
	constexpr Vector2 operator*(real_t p_s) const { return Vector2(x * p_s, y * p_s); }
	constexpr Vector2 operator/(real_t p_s) const { return Vector2(x / p_s, y / p_s); }
	constexpr Vector2 &operator+=(const Vector2 &p_v) { return *this = *this + p_v; }
	constexpr Vector2 &operator-=(const Vector2 &p_v) { return *this = *this - p_v; }
	constexpr Vector2 &operator*=(const Vector2 &p_v) { return *this = *this * p_v; }
	constexpr Vector2 &operator/=(const Vector2 &p_v) { return *this = *this / p_v; }
	constexpr Vector2 &operator*=(real_t p_s) { return *this = *this * p_s; }
	constexpr Vector2 &operator/=(real_t p_s) { return *this = *this / p_s; }
	constexpr Vector2 operator-() const { return Vector2(-x, -y); }
	constexpr bool operator==(const Vector2 &p_v) const { return x == p_v.x && y == p_v.y; }
	constexpr bool operator!=(const Vector2 &p_v) const { return !(*this == p_v); }
	constexpr bool operator<(const Vector2 &p_v) const { return x != p_v.x ? x < p_v.x : y < p_v.y; }

	constexpr real_t dot(const Vector2 &p_v) const { return x * p_v.x + y * p_v.y; }
	constexpr real_t length_squared() const { return dot(*this); }
	real_t length() const { return std::sqrt(length_squared()); }
	Vector2 normalized() const {
		const real_t l = length_squared();
		return l == 0 ? Vector2() : *this / std::sqrt(l);
	}
	void normalize() { *this = normalized(); }
	real_t distance_to(const Vector2 &p_to) const { return (p_to - *this).length(); }
	constexpr Vector2 lerp(const Vector2 &p_to, real_t p_weight) const { return *this + (p_to - *this) * p_weight; }
	bool is_finite() const { return std::isfinite(x) && std::isfinite(y); }
	bool is_equal_approx(const Vector2 &p_v) const {
		return Math::is_equal_approx(x, p_v.x) && Math::is_equal_approx(y, p_v.y);
	}
	bool is_zero_approx() const { return Math::is_zero_approx(x) && Math::is_zero_approx(y); }
	constexpr real_t cross(const Vector2 &p_v) const { return x * p_v.y - y * p_v.x; }
	real_t angle() const { return std::atan2(y, x); }

#include <godot_cpp/generated/vector2_methods.inc>
};

constexpr Vector2 operator*(real_t p_s, const Vector2 &p_v) {
	return p_v * p_s;
}

} // namespace godot

#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/vector2.hpp>

namespace godot {

class Vector2i {
public:
	enum Axis {
		AXIS_X,
		AXIS_Y,
	};

	int32_t x = 0;
	int32_t y = 0;

	constexpr Vector2i() = default;
	constexpr Vector2i(int32_t p_x, int32_t p_y) : x(p_x), y(p_y) {}
	constexpr explicit Vector2i(const Vector2 &p_v) : x(int32_t(p_v.x)), y(int32_t(p_v.y)) {}
	constexpr operator Vector2() const { return Vector2(real_t(x), real_t(y)); }

	constexpr int32_t &operator[](int p_axis) { return p_axis == 0 ? x : y; }
	constexpr const int32_t &operator[](int p_axis) const { return p_axis == 0 ? x : y; }
	constexpr Vector2i operator+(const Vector2i &p_v) const { return Vector2i(x + p_v.x, y + p_v.y); }
	constexpr Vector2i operator-(const Vector2i &p_v) const { return Vector2i(x - p_v.x, y - p_v.y); }
	constexpr Vector2i operator*(const Vector2i &p_v) const { return Vector2i(x * p_v.x, y * p_v.y); }
	constexpr Vector2i operator/(const Vector2i &p_v) const { return Vector2i(x / p_v.x, y / p_v.y); }
	constexpr Vector2i operator*(int32_t p_s) const { return Vector2i(x * p_s, y * p_s); }
	constexpr Vector2i operator/(int32_t p_s) const { return Vector2i(x / p_s, y / p_s); }
	constexpr Vector2i &operator+=(const Vector2i &p_v) { return *this = *this + p_v; }
	constexpr Vector2i &operator-=(const Vector2i &p_v) { return *this = *this - p_v; }
	constexpr Vector2i &operator*=(const Vector2i &p_v) { return *this = *this * p_v; }
	constexpr Vector2i &operator/=(const Vector2i &p_v) { return *this = *this / p_v; }
	constexpr Vector2i &operator*=(int32_t p_s) { return *this = *this * p_s; }
	constexpr Vector2i &operator/=(int32_t p_s) { return *this = *this / p_s; }
	constexpr Vector2i operator-() const { return Vector2i(-x, -y); }
	constexpr bool operator==(const Vector2i &p_v) const { return x == p_v.x && y == p_v.y; }
	constexpr bool operator!=(const Vector2i &p_v) const { return !(*this == p_v); }
	constexpr bool operator<(const Vector2i &p_v) const { return x != p_v.x ? x < p_v.x : y < p_v.y; }

#include <godot_cpp/generated/vector2i_methods.inc>
};

constexpr Vector2i operator*(int32_t p_s, const Vector2i &p_v) {
	return p_v * p_s;
}

} // namespace godot

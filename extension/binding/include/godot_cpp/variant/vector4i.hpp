#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/vector4.hpp>

namespace godot {

class Vector4i {
public:
	enum Axis {
		AXIS_X,
		AXIS_Y,
		AXIS_Z,
		AXIS_W,
	};

	int32_t x = 0;
	int32_t y = 0;
	int32_t z = 0;
	int32_t w = 0;

	constexpr Vector4i() = default;
	constexpr Vector4i(int32_t p_x, int32_t p_y, int32_t p_z, int32_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}
	constexpr explicit Vector4i(const Vector4 &p_v) :
			x(int32_t(p_v.x)), y(int32_t(p_v.y)), z(int32_t(p_v.z)), w(int32_t(p_v.w)) {}
	constexpr operator Vector4() const { return Vector4(real_t(x), real_t(y), real_t(z), real_t(w)); }

	constexpr int32_t &operator[](int p_axis) { return p_axis == 0 ? x : (p_axis == 1 ? y : (p_axis == 2 ? z : w)); }
	constexpr const int32_t &operator[](int p_axis) const {
		return p_axis == 0 ? x : (p_axis == 1 ? y : (p_axis == 2 ? z : w));
	}
	constexpr Vector4i operator+(const Vector4i &p_v) const {
		return Vector4i(x + p_v.x, y + p_v.y, z + p_v.z, w + p_v.w);
	}
	constexpr Vector4i operator-(const Vector4i &p_v) const {
		return Vector4i(x - p_v.x, y - p_v.y, z - p_v.z, w - p_v.w);
	}
	constexpr Vector4i operator*(const Vector4i &p_v) const {
		return Vector4i(x * p_v.x, y * p_v.y, z * p_v.z, w * p_v.w);
	}
	constexpr Vector4i operator/(const Vector4i &p_v) const {
		return Vector4i(x / p_v.x, y / p_v.y, z / p_v.z, w / p_v.w);
	}
	constexpr Vector4i operator*(int32_t p_s) const { return Vector4i(x * p_s, y * p_s, z * p_s, w * p_s); }
	constexpr Vector4i operator/(int32_t p_s) const { return Vector4i(x / p_s, y / p_s, z / p_s, w / p_s); }
	constexpr Vector4i &operator+=(const Vector4i &p_v) { return *this = *this + p_v; }
	constexpr Vector4i &operator-=(const Vector4i &p_v) { return *this = *this - p_v; }
	constexpr Vector4i &operator*=(const Vector4i &p_v) { return *this = *this * p_v; }
	constexpr Vector4i &operator/=(const Vector4i &p_v) { return *this = *this / p_v; }
	constexpr Vector4i &operator*=(int32_t p_s) { return *this = *this * p_s; }
	constexpr Vector4i &operator/=(int32_t p_s) { return *this = *this / p_s; }
	constexpr Vector4i operator-() const { return Vector4i(-x, -y, -z, -w); }
	constexpr bool operator==(const Vector4i &p_v) const {
		return x == p_v.x && y == p_v.y && z == p_v.z && w == p_v.w;
	}
	constexpr bool operator!=(const Vector4i &p_v) const { return !(*this == p_v); }
	constexpr bool operator<(const Vector4i &p_v) const {
		return x != p_v.x ? x < p_v.x : y != p_v.y ? y < p_v.y : z != p_v.z ? z < p_v.z : w < p_v.w;
	}

#include <godot_cpp/generated/vector4i_methods.inc>
};

constexpr Vector4i operator*(int32_t p_s, const Vector4i &p_v) {
	return p_v * p_s;
}

} // namespace godot

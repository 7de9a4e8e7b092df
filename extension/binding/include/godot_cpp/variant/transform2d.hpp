#pragma once

#include <godot_cpp/variant/rect2.hpp>

namespace godot {

class PackedVector2Array;

class Transform2D {
public:
	// The two axes, then the origin.
	Vector2 columns[3] = { Vector2(1, 0), Vector2(0, 1), Vector2() };

	constexpr Transform2D() = default;
	constexpr Transform2D(const Vector2 &p_x, const Vector2 &p_y, const Vector2 &p_origin) :
			columns{ p_x, p_y, p_origin } {}
	constexpr Transform2D(real_t p_xx, real_t p_xy, real_t p_yx, real_t p_yy, real_t p_ox, real_t p_oy) :
			columns{ Vector2(p_xx, p_xy), Vector2(p_yx, p_yy), Vector2(p_ox, p_oy) } {}

	constexpr const Vector2 &operator[](int p_index) const { return columns[p_index]; }
	constexpr Vector2 &operator[](int p_index) { return columns[p_index]; }
	constexpr Vector2 xform(const Vector2 &p_v) const { return columns[0] * p_v.x + columns[1] * p_v.y + columns[2]; }
	constexpr Vector2 operator*(const Vector2 &p_v) const { return xform(p_v); }
	constexpr bool operator==(const Transform2D &p_t) const {
		return columns[0] == p_t.columns[0] && columns[1] == p_t.columns[1] && columns[2] == p_t.columns[2];
	}
	constexpr bool operator!=(const Transform2D &p_t) const { return !(*this == p_t); }

#include <godot_cpp/generated/transform2d_methods.inc>
};

} // namespace godot

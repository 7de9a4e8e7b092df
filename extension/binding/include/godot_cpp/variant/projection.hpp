#pragma once

#include <godot_cpp/variant/rect2.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/vector4.hpp>

namespace godot {

class Projection {
public:
	enum Planes {
		PLANE_NEAR,
		PLANE_FAR,
		PLANE_LEFT,
		PLANE_TOP,
		PLANE_RIGHT,
		PLANE_BOTTOM,
	};

	Vector4 columns[4] = { Vector4(1, 0, 0, 0), Vector4(0, 1, 0, 0), Vector4(0, 0, 1, 0), Vector4(0, 0, 0, 1) };

	constexpr Projection() = default;
	constexpr Projection(const Vector4 &p_x, const Vector4 &p_y, const Vector4 &p_z, const Vector4 &p_w) :
			columns{ p_x, p_y, p_z, p_w } {}

	constexpr const Vector4 &operator[](int p_index) const { return columns[p_index]; }
	constexpr Vector4 &operator[](int p_index) { return columns[p_index]; }
	constexpr bool operator==(const Projection &p_p) const {
		return columns[0] == p_p[0] && columns[1] == p_p[1] && columns[2] == p_p[2] && columns[3] == p_p[3];
	}
	constexpr bool operator!=(const Projection &p_p) const { return !(*this == p_p); }

#include <godot_cpp/generated/projection_methods.inc>
};

} // namespace godot

#pragma once

#include <godot_cpp/variant/quaternion.hpp>

namespace godot {

// A 3x3 matrix, stored by rows. Its columns are the axes x, y and z of scripts.
class Basis {
public:
	Vector3 rows[3] = { Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1) };

	constexpr Basis() = default;
	constexpr Basis(const Vector3 &p_x_axis, const Vector3 &p_y_axis, const Vector3 &p_z_axis) :
			rows{ Vector3(p_x_axis.x, p_y_axis.x, p_z_axis.x), Vector3(p_x_axis.y, p_y_axis.y, p_z_axis.y),
				Vector3(p_x_axis.z, p_y_axis.z, p_z_axis.z) } {}
	constexpr Basis(real_t p_xx, real_t p_xy, real_t p_xz, real_t p_yx, real_t p_yy, real_t p_yz, real_t p_zx,
			real_t p_zy, real_t p_zz) :
			rows{ Vector3(p_xx, p_xy, p_xz), Vector3(p_yx, p_yy, p_yz), Vector3(p_zx, p_zy, p_zz) } {}
	Basis(const Quaternion &p_quaternion);
	// The axis has length 1, and the angle is in radians.
	Basis(const Vector3 &p_axis, real_t p_angle) : Basis(Quaternion(p_axis, p_angle)) {}

	constexpr const Vector3 &operator[](int p_row) const { return rows[p_row]; }
	constexpr Vector3 &operator[](int p_row) { return rows[p_row]; }
	constexpr Vector3 get_column(int p_index) const {
		return Vector3(rows[0][p_index], rows[1][p_index], rows[2][p_index]);
	}
	constexpr void set_column(int p_index, const Vector3 &p_value) {
		rows[0][p_index] = p_value.x;
		rows[1][p_index] = p_value.y;
		rows[2][p_index] = p_value.z;
	}
	constexpr void set_columns(const Vector3 &p_x, const Vector3 &p_y, const Vector3 &p_z) {
		*this = Basis(p_x, p_y, p_z);
	}
	Quaternion get_quaternion() const { return get_rotation_quaternion(); }
	constexpr real_t determinant() const { return rows[0].dot(rows[1].cross(rows[2])); }
	constexpr Basis transposed() const { return Basis(rows[0], rows[1], rows[2]); }

	constexpr Vector3 xform(const Vector3 &p_v) const {
		return Vector3(rows[0].dot(p_v), rows[1].dot(p_v), rows[2].dot(p_v));
	}
	constexpr Vector3 xform_inv(const Vector3 &p_v) const { return transposed().xform(p_v); }
	constexpr Basis operator*(const Basis &p_b) const {
		return Basis(xform(p_b.get_column(0)), xform(p_b.get_column(1)), xform(p_b.get_column(2)));
	}
	constexpr Basis &operator*=(const Basis &p_b) { return *this = *this * p_b; }
	constexpr Basis operator*(real_t p_s) const {
		return Basis(get_column(0) * p_s, get_column(1) * p_s, get_column(2) * p_s);
	}
	constexpr bool operator==(const Basis &p_b) const {
		return rows[0] == p_b.rows[0] && rows[1] == p_b.rows[1] && rows[2] == p_b.rows[2];
	}
	constexpr bool operator!=(const Basis &p_b) const { return !(*this == p_b); }

#include <godot_cpp/generated/basis_methods.inc>
};

} // namespace godot

#pragma once

#include <godot_cpp/variant/aabb.hpp>
#include <godot_cpp/variant/basis.hpp>

namespace godot {

class PackedVector3Array;

class Transform3D {
public:
	Basis basis;
	Vector3 origin;

	constexpr Transform3D() = default;
	constexpr Transform3D(const Basis &p_basis, const Vector3 &p_origin = Vector3()) :
			basis(p_basis), origin(p_origin) {}
	constexpr Transform3D(const Vector3 &p_x, const Vector3 &p_y, const Vector3 &p_z, const Vector3 &p_origin) :
			basis(p_x, p_y, p_z), origin(p_origin) {}
	// By rows, with the origin last.
	constexpr Transform3D(real_t p_xx, real_t p_xy, real_t p_xz, real_t p_yx, real_t p_yy, real_t p_yz, real_t p_zx,
			real_t p_zy, real_t p_zz, real_t p_ox, real_t p_oy, real_t p_oz) :
			basis(p_xx, p_xy, p_xz, p_yx, p_yy, p_yz, p_zx, p_zy, p_zz), origin(p_ox, p_oy, p_oz) {}

	constexpr const Basis &get_basis() const { return basis; }
	constexpr const Vector3 &get_origin() const { return origin; }
	constexpr void set_basis(const Basis &p_basis) { basis = p_basis; }
	constexpr void set_origin(const Vector3 &p_origin) { origin = p_origin; }
	constexpr Vector3 xform(const Vector3 &p_v) const { return basis.xform(p_v) + origin; }
	// Correct for orthonormal bases only.
	constexpr Vector3 xform_inv(const Vector3 &p_v) const { return basis.xform_inv(p_v - origin); }
	constexpr Vector3 operator*(const Vector3 &p_v) const { return xform(p_v); }
	constexpr Transform3D operator*(const Transform3D &p_t) const {
		return Transform3D(basis * p_t.basis, xform(p_t.origin));
	}
	constexpr Transform3D &operator*=(const Transform3D &p_t) { return *this = *this * p_t; }
	constexpr bool operator==(const Transform3D &p_t) const { return basis == p_t.basis && origin == p_t.origin; }
	constexpr bool operator!=(const Transform3D &p_t) const { return !(*this == p_t); }

#include <godot_cpp/generated/transform3d_methods.inc>
};

} // namespace godot

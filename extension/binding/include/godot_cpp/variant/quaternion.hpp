#pragma once

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

class Basis;

class Quaternion {
public:
	real_t x = 0;
	real_t y = 0;
	real_t z = 0;
	real_t w = 1;

	constexpr Quaternion() = default;
	constexpr Quaternion(real_t p_x, real_t p_y, real_t p_z, real_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}
	// The axis has length 1, and the angle is in radians.
	Quaternion(const Vector3 &p_axis, real_t p_angle);
	// The shortest rotation from one direction to another.
	Quaternion(const Vector3 &p_from, const Vector3 &p_to);
	Quaternion(const Basis &p_basis);

	constexpr real_t dot(const Quaternion &p_q) const { return x * p_q.x + y * p_q.y + z * p_q.z + w * p_q.w; }
	constexpr real_t length_squared() const { return dot(*this); }
	real_t length() const { return std::sqrt(length_squared()); }
	Quaternion normalized() const { return *this / length(); }
	void normalize() { *this = normalized(); }
	constexpr Quaternion inverse() const { return Quaternion(-x, -y, -z, w); }
	constexpr Vector3 xform(const Vector3 &p_v) const {
		const Vector3 u(x, y, z);
		const Vector3 uv = u.cross(p_v);
		return p_v + (uv * w + u.cross(uv)) * real_t(2);
	}

	constexpr Quaternion operator*(const Quaternion &p_q) const {
		return Quaternion(w * p_q.x + x * p_q.w + y * p_q.z - z * p_q.y, w * p_q.y + y * p_q.w + z * p_q.x - x * p_q.z,
				w * p_q.z + z * p_q.w + x * p_q.y - y * p_q.x, w * p_q.w - x * p_q.x - y * p_q.y - z * p_q.z);
	}
	constexpr Quaternion &operator*=(const Quaternion &p_q) { return *this = *this * p_q; }
	constexpr Vector3 operator*(const Vector3 &p_v) const { return xform(p_v); }
	constexpr Quaternion operator*(real_t p_s) const { return Quaternion(x * p_s, y * p_s, z * p_s, w * p_s); }
	constexpr Quaternion operator/(real_t p_s) const { return *this * (real_t(1) / p_s); }
	constexpr Quaternion operator+(const Quaternion &p_q) const {
		return Quaternion(x + p_q.x, y + p_q.y, z + p_q.z, w + p_q.w);
	}
	constexpr Quaternion operator-(const Quaternion &p_q) const {
		return Quaternion(x - p_q.x, y - p_q.y, z - p_q.z, w - p_q.w);
	}
	constexpr Quaternion operator-() const { return Quaternion(-x, -y, -z, -w); }
	constexpr bool operator==(const Quaternion &p_q) const {
		return x == p_q.x && y == p_q.y && z == p_q.z && w == p_q.w;
	}
	constexpr bool operator!=(const Quaternion &p_q) const { return !(*this == p_q); }

#include <godot_cpp/generated/quaternion_methods.inc>
};

} // namespace godot

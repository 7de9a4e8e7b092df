#pragma once

#include <cmath>

#include <godot_cpp/core/defs.hpp>

// The common helpers of godot-cpp's Math. Larger functions belong to code without the engine.

#define CMP_EPSILON 0.00001f
#define CMP_EPSILON2 (CMP_EPSILON * CMP_EPSILON)
#define UNIT_EPSILON 0.001f

#ifndef SIGN
#define SIGN(m_v) (((m_v) > 0) ? +1.0f : (((m_v) < 0) ? -1.0f : 0.0f))
#endif
#ifndef ABS
#define ABS(m_v) (((m_v) < 0) ? (-(m_v)) : (m_v))
#endif

namespace godot {

template <typename T, typename U> constexpr auto MIN(const T p_a, const U p_b) {
	return p_a < p_b ? p_a : p_b;
}
template <typename T, typename U> constexpr auto MAX(const T p_a, const U p_b) {
	return p_a > p_b ? p_a : p_b;
}
template <typename T, typename U, typename V> constexpr auto CLAMP(const T p_a, const U p_min, const V p_max) {
	return p_a < p_min ? p_min : (p_a > p_max ? p_max : p_a);
}

namespace Math {

constexpr double PI = 3.1415926535897932384626433833;
constexpr double TAU = 2 * PI;

using std::abs;
using std::acos;
using std::asin;
using std::atan;
using std::atan2;
using std::ceil;
using std::cos;
using std::exp;
using std::floor;
using std::fmod;
using std::isfinite;
using std::log;
using std::pow;
using std::round;
using std::sin;
using std::sqrt;
using std::tan;

template <typename T> inline bool is_nan(T p_value) {
	return std::isnan(p_value);
}
template <typename T> inline bool is_inf(T p_value) {
	return std::isinf(p_value);
}
template <typename T> inline bool is_finite(T p_value) {
	return std::isfinite(p_value);
}
template <typename T> inline T deg_to_rad(T p_degrees) {
	return p_degrees * T(PI / 180.0);
}
template <typename T> inline T rad_to_deg(T p_radians) {
	return p_radians * T(180.0 / PI);
}
template <typename T> inline T lerp(T p_from, T p_to, T p_weight) {
	return p_from + (p_to - p_from) * p_weight;
}
template <typename T> inline bool is_zero_approx(T p_value) {
	return std::abs(p_value) < T(CMP_EPSILON);
}
template <typename T> inline bool is_equal_approx(T p_left, T p_right) {
	if (p_left == p_right) {
		return true;
	}
	const T tolerance = T(CMP_EPSILON) * std::abs(p_left);
	return std::abs(p_left - p_right) < (tolerance < T(CMP_EPSILON) ? T(CMP_EPSILON) : tolerance);
}

} // namespace Math

} // namespace godot

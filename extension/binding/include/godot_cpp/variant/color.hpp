#pragma once

#include <godot_cpp/core/math.hpp>

namespace godot {

class String;

class Color {
public:
	float r = 0;
	float g = 0;
	float b = 0;
	float a = 1;

	constexpr Color() = default;
	constexpr Color(float p_r, float p_g, float p_b, float p_a = 1) : r(p_r), g(p_g), b(p_b), a(p_a) {}
	constexpr Color(const Color &p_color, float p_a) : r(p_color.r), g(p_color.g), b(p_color.b), a(p_a) {}

	constexpr const float &operator[](int p_index) const {
		return p_index == 0 ? r : (p_index == 1 ? g : (p_index == 2 ? b : a));
	}
	constexpr float &operator[](int p_index) { return p_index == 0 ? r : (p_index == 1 ? g : (p_index == 2 ? b : a)); }
	constexpr Color operator+(const Color &p_c) const { return Color(r + p_c.r, g + p_c.g, b + p_c.b, a + p_c.a); }
	constexpr Color operator-(const Color &p_c) const { return Color(r - p_c.r, g - p_c.g, b - p_c.b, a - p_c.a); }
	constexpr Color operator*(const Color &p_c) const { return Color(r * p_c.r, g * p_c.g, b * p_c.b, a * p_c.a); }
	constexpr Color operator*(float p_s) const { return Color(r * p_s, g * p_s, b * p_s, a * p_s); }
	constexpr Color operator/(float p_s) const { return Color(r / p_s, g / p_s, b / p_s, a / p_s); }
	constexpr bool operator==(const Color &p_c) const { return r == p_c.r && g == p_c.g && b == p_c.b && a == p_c.a; }
	constexpr bool operator!=(const Color &p_c) const { return !(*this == p_c); }
	constexpr Color lerp(const Color &p_to, float p_weight) const { return *this + (p_to - *this) * p_weight; }

#include <godot_cpp/generated/color_methods.inc>
};

} // namespace godot

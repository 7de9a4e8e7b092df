#pragma once

#include <godot_cpp/variant/vector2.hpp>

namespace godot {

class Rect2 {
public:
	Vector2 position;
	Vector2 size;

	constexpr Rect2() = default;
	constexpr Rect2(const Vector2 &p_position, const Vector2 &p_size) : position(p_position), size(p_size) {}
	constexpr Rect2(real_t p_x, real_t p_y, real_t p_width, real_t p_height) :
			position(p_x, p_y), size(p_width, p_height) {}

	constexpr Vector2 get_position() const { return position; }
	constexpr Vector2 get_size() const { return size; }
	constexpr Vector2 get_end() const { return position + size; }
	constexpr bool operator==(const Rect2 &p_rect) const { return position == p_rect.position && size == p_rect.size; }
	constexpr bool operator!=(const Rect2 &p_rect) const { return !(*this == p_rect); }

#include <godot_cpp/generated/rect2_methods.inc>
};

} // namespace godot

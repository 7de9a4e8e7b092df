#pragma once

#include <godot_cpp/variant/vector2i.hpp>

namespace godot {

class Rect2i {
public:
	Vector2i position;
	Vector2i size;

	constexpr Rect2i() = default;
	constexpr Rect2i(const Vector2i &p_position, const Vector2i &p_size) : position(p_position), size(p_size) {}
	constexpr Rect2i(int32_t p_x, int32_t p_y, int32_t p_width, int32_t p_height) :
			position(p_x, p_y), size(p_width, p_height) {}

	constexpr Vector2i get_position() const { return position; }
	constexpr Vector2i get_size() const { return size; }
	constexpr Vector2i get_end() const { return position + size; }
	constexpr bool operator==(const Rect2i &p_rect) const { return position == p_rect.position && size == p_rect.size; }
	constexpr bool operator!=(const Rect2i &p_rect) const { return !(*this == p_rect); }

#include <godot_cpp/generated/rect2i_methods.inc>
};

} // namespace godot

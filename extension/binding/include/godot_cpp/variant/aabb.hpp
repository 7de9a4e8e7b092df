#pragma once

#include <godot_cpp/variant/plane.hpp>

namespace godot {

class AABB {
public:
	Vector3 position;
	Vector3 size;

	constexpr AABB() = default;
	constexpr AABB(const Vector3 &p_position, const Vector3 &p_size) : position(p_position), size(p_size) {}

	constexpr Vector3 get_position() const { return position; }
	constexpr Vector3 get_size() const { return size; }
	constexpr Vector3 get_end() const { return position + size; }
	void expand_to(const Vector3 &p_point) { *this = expand(p_point); }
	void merge_with(const AABB &p_with) { *this = merge(p_with); }
	void grow_by(real_t p_amount) { *this = grow(p_amount); }
	constexpr bool operator==(const AABB &p_box) const { return position == p_box.position && size == p_box.size; }
	constexpr bool operator!=(const AABB &p_box) const { return !(*this == p_box); }

#include <godot_cpp/generated/aabb_methods.inc>
};

} // namespace godot

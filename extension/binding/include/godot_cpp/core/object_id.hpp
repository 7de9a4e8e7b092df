#pragma once

#include <godot_cpp/core/defs.hpp>

namespace godot {

class ObjectID {
	uint64_t id = 0;

public:
	constexpr ObjectID() = default;
	constexpr explicit ObjectID(uint64_t p_id) : id(p_id) {}
	constexpr bool is_valid() const { return id != 0; }
	constexpr bool is_null() const { return id == 0; }
	constexpr operator uint64_t() const { return id; }
};

} // namespace godot

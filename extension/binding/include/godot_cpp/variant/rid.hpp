#pragma once

#include <godot_cpp/core/defs.hpp>

namespace godot {

class RID {
	uint64_t _id = 0;

public:
	constexpr RID() = default;

	constexpr int64_t get_id() const { return int64_t(_id); }
	constexpr bool is_valid() const { return _id != 0; }
	constexpr bool is_null() const { return _id == 0; }
	constexpr bool operator==(const RID &p_rid) const { return _id == p_rid._id; }
	constexpr bool operator!=(const RID &p_rid) const { return _id != p_rid._id; }
	constexpr bool operator<(const RID &p_rid) const { return _id < p_rid._id; }

#include <godot_cpp/generated/rid_methods.inc>
};

} // namespace godot

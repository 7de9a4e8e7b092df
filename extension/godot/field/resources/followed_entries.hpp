#pragma once

#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/callable.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Connections to the `changed` signals of resources in an array that users set. An array has no signal for appended or
/// replaced entries, so differ() compares it with the connected ones.
class FollowedEntries {
public:
	/// Connects `changed` to these entries, some of which may be null, and disconnects it from all earlier ones.
	void follow(const godot::Array &entries, const godot::Callable &changed);
	/// True if these entries are not the connected ones.
	bool differ(const godot::Array &entries) const;

private:
	std::vector<uint64_t> followed; ///< Instance ids; 0: null.
};

} // namespace undergrowth

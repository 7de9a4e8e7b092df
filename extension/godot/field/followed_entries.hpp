#pragma once

#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/callable.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Resources in an array that users set, each of which tells of its changes. That one was appended or exchanged tells
/// nobody: the array is compared with those that are followed.
class FollowedEntries {
public:
	/// `changed` is called for these, some of which may be null, and for none that were followed before.
	void follow(const godot::Array &entries, const godot::Callable &changed);
	/// Whether these are others than are followed.
	bool differ(const godot::Array &entries) const;

private:
	std::vector<uint64_t> followed; ///< Instance ids; 0: null.
};

} // namespace undergrowth

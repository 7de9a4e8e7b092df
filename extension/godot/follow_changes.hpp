#pragma once

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/callable.hpp>

namespace undergrowth {

/// Calls `listener` whenever `resource`, which may be null, changes. Once, however often this is asked for: when the
/// library is reloaded, connections outlive what its former self knew of them.
inline void follow_changes(godot::Resource *resource, const godot::Callable &listener) {
	if (resource && !resource->is_connected("changed", listener)) {
		resource->connect("changed", listener);
	}
}

/// Ends that.
inline void unfollow_changes(godot::Resource *resource, const godot::Callable &listener) {
	if (resource && resource->is_connected("changed", listener)) {
		resource->disconnect("changed", listener);
	}
}

} // namespace undergrowth

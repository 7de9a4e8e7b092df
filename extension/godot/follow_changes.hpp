#pragma once

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/callable.hpp>

namespace undergrowth {

/// Calls `listener` whenever `object` emits `signal`, or no more. Once, however often this is asked for: when the
/// library is reloaded, connections outlive what its former self knew of them.
inline void follow_signal(godot::Object *object, const char *signal, const godot::Callable &listener, bool on = true) {
	const bool follows = object->is_connected(signal, listener);
	if (on && !follows) {
		object->connect(signal, listener);
	} else if (!on && follows) {
		object->disconnect(signal, listener);
	}
}

/// The same of whatever changes in `resource`, which may be null.
inline void follow_changes(godot::Resource *resource, const godot::Callable &listener) {
	if (resource) {
		follow_signal(resource, "changed", listener);
	}
}

/// Ends that.
inline void unfollow_changes(godot::Resource *resource, const godot::Callable &listener) {
	if (resource) {
		follow_signal(resource, "changed", listener, false);
	}
}

} // namespace undergrowth

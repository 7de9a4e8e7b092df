#pragma once

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/callable.hpp>

namespace undergrowth {

/// Connects `listener` to `signal` of `object`, or disconnects it. Repeated calls connect it once. The engine is the
/// source for existing connections, because they outlive a reload of the library.
inline void follow_signal(godot::Object *object, const char *signal, const godot::Callable &listener, bool on = true) {
	const bool follows = object->is_connected(signal, listener);
	if (on && !follows) {
		object->connect(signal, listener);
	} else if (!on && follows) {
		object->disconnect(signal, listener);
	}
}

/// Connects `listener` to the signal `changed` of `resource`, which may be null.
inline void follow_changes(godot::Resource *resource, const godot::Callable &listener) {
	if (resource) {
		follow_signal(resource, "changed", listener);
	}
}

/// Disconnects `listener` from the signal `changed` of `resource`, which may be null.
inline void unfollow_changes(godot::Resource *resource, const godot::Callable &listener) {
	if (resource) {
		follow_signal(resource, "changed", listener, false);
	}
}

} // namespace undergrowth

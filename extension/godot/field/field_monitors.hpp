#pragma once

#include <godot_cpp/core/object.hpp>

namespace undergrowth {

class Meadow;

/// The engine's Performance monitors of all fields in the tree. Main thread only.
struct FieldMonitors {
	/// `answers`: the field's node; its _on_monitor_asked(which) returns sum(which).
	static void enter(const Meadow *meadow, godot::Object *answers);
	static void leave(const Meadow *meadow);
	/// Sum of one monitor over all fields.
	static double sum(int which);
};

} // namespace undergrowth

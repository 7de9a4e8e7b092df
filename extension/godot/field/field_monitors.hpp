#pragma once

#include <godot_cpp/core/object.hpp>

namespace undergrowth {

class FieldRuntime;

/// The engine's Performance monitors of all fields in the tree. Main thread only.
struct FieldMonitors {
	/// `answers`: the field's node; its _on_monitor_asked(which) returns sum(which).
	static void enter(const FieldRuntime *runtime, godot::Object *answers);
	static void leave(const FieldRuntime *runtime);
	/// Sum of one monitor over all fields.
	static double sum(int which);
};

} // namespace undergrowth

#pragma once

#include <godot_cpp/core/object.hpp>

namespace undergrowth {

class FieldRuntime;

/// The add-on's Performance monitors, which are sums over all fields in the tree. Main thread.
struct FieldMonitors {
	/// Registers the monitors with the engine, which reads each by the method _on_monitor_read(which) of `reader`.
	static void add(godot::Object *reader);
	static void remove();
	/// Value of a monitor for one field. `which` is its index in MONITOR_NAMES.
	static double read(const FieldRuntime &field, int which);
};

} // namespace undergrowth

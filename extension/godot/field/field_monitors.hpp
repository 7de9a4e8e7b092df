#pragma once

#include <godot_cpp/core/object.hpp>

namespace undergrowth {

class FieldRuntime;

/// Registers the add-on's Performance monitors with the engine while at least one field is in a tree. Owns the list of
/// these fields. Main thread.
struct FieldMonitors {
	/// Adds a field to the list. `node` is its PlantField3D; the engine reads a monitor through the node's method
	/// _on_monitor_read(which), which returns sum(which).
	static void enter(const FieldRuntime *runtime, godot::Object *node);
	/// Removes the field. The last one removes the monitors.
	static void leave(const FieldRuntime *runtime);
	/// Sum of a monitor over all listed fields. `which` is its index in MONITOR_NAMES.
	static double sum(int which);
};

} // namespace undergrowth

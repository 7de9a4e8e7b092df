#include "field/field_monitors.hpp"

#include "field/field_runtime.hpp"

#include <godot_cpp/classes/performance.hpp>
#include <godot_cpp/variant/callable.hpp>

using namespace godot;

namespace undergrowth {

enum Monitor { MONITOR_PLANTS, MONITOR_SIMULATED, MONITOR_STEP, MONITOR_UPLOAD, MONITORS };
static const char *const MONITOR_NAMES[MONITORS] = { "undergrowth/field_plants", "undergrowth/field_simulated",
	"undergrowth/field_step_usec", "undergrowth/field_upload_usec" };

void FieldMonitors::add(Object *reader) {
	remove(); // Those of a reader before a reload of the library.
	for (int i = 0; i < MONITORS; i++) {
		Array arguments;
		arguments.push_back(i);
		// By name: its signature is another one in Godot 4.5.
		Performance::get_singleton()->call(
				"add_custom_monitor", MONITOR_NAMES[i], Callable(reader, "_on_monitor_read"), arguments);
	}
}

void FieldMonitors::remove() {
	Performance *performance = Performance::get_singleton();
	for (const char *name : MONITOR_NAMES) {
		if (performance->has_custom_monitor(name)) {
			performance->remove_custom_monitor(name);
		}
	}
}

double FieldMonitors::read(const FieldRuntime &field, int which) {
	switch (which) {
		case MONITOR_PLANTS:
			return field.store.plant_count();
		case MONITOR_SIMULATED:
			return field.motion.simulated_count(field.store);
		case MONITOR_STEP:
			return field.motion.busy_usec();
		case MONITOR_UPLOAD:
			return field.upload_usec;
		default:
			return 0.0;
	}
}

} // namespace undergrowth

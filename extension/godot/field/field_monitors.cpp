#include "field/field_monitors.hpp"

#include "field/field_runtime.hpp"

#include <godot_cpp/classes/performance.hpp>
#include <godot_cpp/variant/callable.hpp>

#include <algorithm>
#include <utility>
#include <vector>

using namespace godot;

namespace undergrowth {

enum Monitor { MONITOR_PLANTS, MONITOR_SIMULATED, MONITOR_STEP, MONITOR_UPLOAD, MONITORS };
static const char *const MONITOR_NAMES[MONITORS] = { "undergrowth/field_plants", "undergrowth/field_simulated",
	"undergrowth/field_step_usec", "undergrowth/field_upload_usec" };

using Fields = std::vector<std::pair<const FieldRuntime *, Object *>>;

static Fields &registered_fields() {
	static Fields fields;
	return fields;
}

// The first field in the tree serves the monitors of all fields.
static void choose_answering_field() {
	Performance *performance = Performance::get_singleton();
	for (int i = 0; i < MONITORS; i++) {
		if (performance->has_custom_monitor(MONITOR_NAMES[i])) {
			performance->remove_custom_monitor(MONITOR_NAMES[i]);
		}
		if (!registered_fields().empty()) {
			Array arguments;
			arguments.push_back(i);
			performance->add_custom_monitor(
					MONITOR_NAMES[i], Callable(registered_fields()[0].second, "_on_monitor_read"), arguments);
		}
	}
}

void FieldMonitors::enter(const FieldRuntime *runtime, Object *answers) {
	registered_fields().push_back({ runtime, answers });
	choose_answering_field();
}

void FieldMonitors::leave(const FieldRuntime *runtime) {
	Fields &fields = registered_fields();
	const auto is_it = [&](const auto &field) { return field.first == runtime; };
	fields.erase(std::remove_if(fields.begin(), fields.end(), is_it), fields.end());
	choose_answering_field();
}

double FieldMonitors::sum(int which) {
	double total = 0.0;
	for (const auto &[runtime, node] : registered_fields()) {
		total += which == MONITOR_PLANTS ? runtime->store.plant_count() : 0.0;
		total += which == MONITOR_SIMULATED ? runtime->motion.simulated_count(runtime->store) : 0.0;
		total += which == MONITOR_STEP ? runtime->motion.busy_usec() : 0.0;
		total += which == MONITOR_UPLOAD ? runtime->upload_usec : 0.0;
	}
	return total;
}

} // namespace undergrowth

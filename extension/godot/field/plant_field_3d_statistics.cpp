// What PlantField3D tells of itself: statistics, and the engine's Performance monitors.

#include "field/plant_field_3d.hpp"

#include "convert.hpp"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/performance.hpp>
#include <godot_cpp/classes/viewport.hpp>

#include <algorithm>

using namespace godot;

namespace undergrowth {

// All fields in the tree, for the monitors. Main thread only.
static std::vector<PlantField3D *> &standing_fields() {
	static std::vector<PlantField3D *> fields;
	return fields;
}

enum Monitor { MONITOR_PLANTS, MONITOR_SIMULATED, MONITOR_STEP, MONITOR_UPLOAD, MONITORS };
static const char *const MONITOR_NAMES[MONITORS] = { "undergrowth/field_plants", "undergrowth/field_simulated",
	"undergrowth/field_step_usec", "undergrowth/field_upload_usec" };

double PlantField3D::monitor(int which) const {
	double sum = 0.0;
	for (const PlantField3D *field : standing_fields()) {
		sum += which == MONITOR_PLANTS ? field->get_plant_count() : 0.0;
		sum += which == MONITOR_SIMULATED && field->simulation ? field->simulation->simulated_count() : 0.0;
		sum += which == MONITOR_STEP ? field->steps.busy_usec() : 0.0;
		sum += which == MONITOR_UPLOAD ? field->upload_usec : 0.0;
	}
	return sum;
}

// The first field in the tree answers for all.
void PlantField3D::count_in_monitors(bool on) {
	std::vector<PlantField3D *> &fields = standing_fields();
	if (on) {
		fields.push_back(this);
	} else {
		fields.erase(std::remove(fields.begin(), fields.end(), this), fields.end());
	}
	Performance *performance = Performance::get_singleton();
	for (int i = 0; i < MONITORS; i++) {
		if (performance->has_custom_monitor(MONITOR_NAMES[i])) {
			performance->remove_custom_monitor(MONITOR_NAMES[i]);
		}
		if (!fields.empty()) {
			Array arguments;
			arguments.push_back(i);
			performance->add_custom_monitor(MONITOR_NAMES[i], Callable(fields[0], "_on_monitor_asked"), arguments);
		}
	}
}

Dictionary PlantField3D::get_statistics() {
	Dictionary told;
	finish_step();
	PackedInt32Array drawn;
	const Camera3D *camera = is_inside_tree() ? get_viewport()->get_camera_3d() : nullptr;
	const Vector3 eye = camera ? axes().affine_inverse().xform(camera->get_global_position()) : Vector3();
	drawn.resize(int64_t(style.levels.size()));
	drawn.fill(0);
	for (const std::unique_ptr<FieldDrawing> &drawing : drawings) {
		const std::vector<int> counts = drawing->count_drawn(style, eye);
		for (size_t i = 0; i < counts.size(); i++) {
			drawn[int64_t(i)] += counts[i];
		}
	}
	size_t bytes = 0;
	for (const std::unique_ptr<FieldPatch> &patch : patches) {
		bytes += patch->plants.bytes() + patch->places.capacity() * sizeof(uint32_t);
	}
	const int count = get_plant_count();
	told["plants"] = count;
	told["simulated"] = simulation ? simulation->simulated_count() : 0;
	told["drawn_by_level"] = drawn;
	told["skeletons"] = int64_t(skeletons.shown.size());
	told["step_usec"] = steps.busy_usec();
	told["upload_usec"] = upload_usec;
	told["main_usec"] = main_usec;
	told["wait_usec"] = wait_usec;
	told["bytes_per_plant"] = count > 0 ? double(bytes) / count + simulation->bytes_per_plant() : 0.0;
	return told;
}

} // namespace undergrowth

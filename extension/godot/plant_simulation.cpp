#include "plant_simulation.hpp"

#include "convert.hpp"
#include "messages.hpp"
#include "plant_3d.hpp"

#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/classes/window.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/callable.hpp>

#include <algorithm>
#include <chrono>

using namespace godot;

namespace undergrowth {

static constexpr double DEFAULT_STEP = 1.0 / 60.0; // s.
static constexpr Range STEP_RANGE = { 0.001, 0.1 };
static const char *const STEP_SETTING = "undergrowth/simulation/step_length";
static const char *const FRAME_METHOD = "_on_process_frame";
static PlantSimulation *singleton = nullptr;

using Clock = std::chrono::steady_clock;

static double microseconds_since(Clock::time_point start) {
	return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

PlantGroup::PlantGroup(Law law, float step, const Ref<PlantWind> &shared_wind, const Basis &axes) :
		batch(law, step), wind(shared_wind), frame(axes) {}

PlantSimulation::PlantSimulation() : clock(DEFAULT_STEP) {
	singleton = this;
	const Variant setting = ProjectSettings::get_singleton()->get_setting(STEP_SETTING, DEFAULT_STEP);
	set_step_length(setting);
}

PlantSimulation::~PlantSimulation() {
	singleton = nullptr;
}

PlantSimulation *PlantSimulation::get_singleton() {
	return singleton;
}

PlantGroup *PlantSimulation::find_group(Law law, const Ref<PlantWind> &wind, const Basis &frame) {
	for (const std::unique_ptr<PlantGroup> &group : groups) {
		if (group->batch.law() == law && group->wind == wind && group->frame == frame) {
			return group.get();
		}
	}
	groups.push_back(std::make_unique<PlantGroup>(law, float(clock.step()), wind, frame));
	return groups.back().get();
}

PlantSimulation::Place PlantSimulation::enter(Plant3D *plant, Law law, const Ref<PlantWind> &wind, const Basis &frame,
		const Joint &joint, const TipState &state) {
	PlantGroup *group = find_group(law, wind, frame);
	group->plants.push_back(plant);
	group->directions.resize(group->plants.size());
	return { group, group->batch.add(joint, state) };
}

void PlantSimulation::leave(const Place &place) {
	PlantGroup *group = place.group;
	const int last = group->batch.size() - 1;
	group->batch.remove(place.index);
	if (place.index != last) {
		group->plants[size_t(place.index)] = group->plants[size_t(last)];
		group->plants[size_t(place.index)]->moved_to(place.index);
	}
	group->plants.pop_back();
}

void PlantSimulation::drop_empty_groups() {
	const auto is_empty = [](const std::unique_ptr<PlantGroup> &group) { return group->plants.empty(); };
	groups.erase(std::remove_if(groups.begin(), groups.end(), is_empty), groups.end());
}

void PlantSimulation::step_groups() {
	step_number++;
	for (const std::unique_ptr<PlantGroup> &group : groups) {
		const glm::vec3 force =
				group->wind.is_valid() ? group->wind->force_of_step(step_number, clock.step()) : glm::vec3(0.0f);
		group->batch.step(to_glm(group->frame.xform_inv(to_godot(force))));
	}
}

void PlantSimulation::pose_plants() {
	const float alpha = clock.alpha();
	for (const std::unique_ptr<PlantGroup> &group : groups) {
		group->batch.interpolate(alpha, group->directions.data());
		for (size_t i = 0; i < group->plants.size(); i++) {
			group->plants[i]->pose(group->directions[i]);
		}
	}
}

void PlantSimulation::advance(double delta) {
	const Clock::time_point start = Clock::now();
	drop_empty_groups();
	for (int steps = clock.advance(delta); steps > 0; steps--) {
		step_groups();
	}
	step_time_usec = microseconds_since(start);
	pose_plants();
	pose_time_usec = microseconds_since(start) - step_time_usec;
}

// The signal comes once a frame before any node's _process, paused or not: plants that pause leave by themselves.
void PlantSimulation::on_process_frame() {
	SceneTree *tree = Object::cast_to<SceneTree>(ObjectDB::get_instance(connected_tree));
	if (tree) {
		advance(tree->get_root()->get_process_delta_time());
	}
}

void PlantSimulation::follow(SceneTree *tree) {
	if (tree->get_instance_id() == connected_tree) {
		return;
	}
	connected_tree = tree->get_instance_id();
	// By name and not by pointer: the connection must survive a reload of the library.
	const Callable frame(this, FRAME_METHOD);
	if (!tree->is_connected("process_frame", frame)) {
		tree->connect("process_frame", frame);
	}
}

int PlantSimulation::get_plant_count() const {
	int count = 0;
	for (const std::unique_ptr<PlantGroup> &group : groups) {
		count += group->batch.size();
	}
	return count;
}

double PlantSimulation::get_step_time_usec() const {
	return step_time_usec;
}

double PlantSimulation::get_pose_time_usec() const {
	return pose_time_usec;
}

double PlantSimulation::get_step_length() const {
	return clock.step();
}

void PlantSimulation::set_step_length(double seconds) {
	if (!accept_value(this, "step_length", seconds, STEP_RANGE) || seconds == clock.step()) {
		return;
	}
	clock = FixedStep(seconds);
	// Each plant's constants hold for one step length: all move to batches of the new one, in their present state.
	std::vector<Plant3D *> everyone;
	for (const std::unique_ptr<PlantGroup> &group : groups) {
		everyone.insert(everyone.end(), group->plants.begin(), group->plants.end());
	}
	for (Plant3D *plant : everyone) {
		plant->leave_simulation();
	}
	drop_empty_groups();
	for (Plant3D *plant : everyone) {
		plant->update_simulation();
	}
}

void PlantSimulation::_bind_methods() {
	ClassDB::bind_method(D_METHOD("_on_process_frame"), &PlantSimulation::on_process_frame);
	ClassDB::bind_method(D_METHOD("get_plant_count"), &PlantSimulation::get_plant_count);
	ClassDB::bind_method(D_METHOD("get_step_time_usec"), &PlantSimulation::get_step_time_usec);
	ClassDB::bind_method(D_METHOD("get_pose_time_usec"), &PlantSimulation::get_pose_time_usec);
	ClassDB::bind_method(D_METHOD("get_step_length"), &PlantSimulation::get_step_length);
	ClassDB::bind_method(D_METHOD("set_step_length", "seconds"), &PlantSimulation::set_step_length);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "step_length", PROPERTY_HINT_RANGE, "0.001,0.1,0.0001,suffix:s"),
			"set_step_length", "get_step_length");
}

} // namespace undergrowth

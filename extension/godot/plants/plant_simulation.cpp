#include "plants/plant_simulation.hpp"

#include "base/convert.hpp"
#include "base/follow_changes.hpp"
#include "base/messages.hpp"
#include "base/world_of.hpp"
#include "climb/climber_motion.hpp"
#include "field/motion/step_batch.hpp"
#include "nodes/plant_3d.hpp"
#include "nodes/plant_field_3d.hpp"
#include "nodes/plant_wind_source_3d.hpp"
#include "species/shared_resources.hpp"

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

PlantGroup *PlantSimulation::find_group(const PlantKind &kind) {
	for (const std::unique_ptr<PlantGroup> &group : groups) {
		if (group->kind == kind) {
			return group.get();
		}
	}
	groups.push_back(std::make_unique<PlantGroup>(kind, float(clock.step())));
	are_groups_new = true;
	return groups.back().get();
}

PlantSimulation::Place PlantSimulation::enter(
		Plant3D *plant, const PlantKind &kind, const MotionPlant &description, const PlantBone &bone) {
	PlantGroup *group = find_group(kind);
	group->add(plant, description, bone);
	is_contact_dirty = is_contact_dirty || kind.forces.has_contact;
	return { group, group->page.size() - 1 };
}

void PlantSimulation::leave(const Place &place) {
	place.group->remove(place.index);
	is_contact_dirty = is_contact_dirty || place.group->kind.forces.has_contact;
}

void PlantSimulation::drop_empty_groups() {
	const auto is_empty = [](const std::unique_ptr<PlantGroup> &group) { return group->plants.empty(); };
	const auto first = std::remove_if(groups.begin(), groups.end(), is_empty);
	are_groups_new = are_groups_new || first != groups.end();
	groups.erase(first, groups.end());
}

void PlantSimulation::follow_groups() {
	if (are_groups_new) {
		bodies.follow(groups);
	}
	if (are_groups_new || is_contact_dirty) {
		contact.follow(groups);
	}
	are_groups_new = is_contact_dirty = false;
}

void PlantSimulation::enter(PlantField3D *field) {
	if (fields.empty()) {
		FieldMonitors::add(this);
	}
	if (std::find(fields.begin(), fields.end(), field) == fields.end()) {
		fields.push_back(field);
	}
}

void PlantSimulation::leave(PlantField3D *field) {
	fields.erase(std::remove(fields.begin(), fields.end(), field), fields.end());
	if (fields.empty()) {
		FieldMonitors::remove();
	}
}

void PlantSimulation::enter(ClimberMotion *climber) {
	if (std::find(climbers.begin(), climbers.end(), climber) == climbers.end()) {
		climber->set_step_length(float(clock.step()));
		climbers.push_back(climber);
	}
}

void PlantSimulation::leave(ClimberMotion *climber) {
	climbers.erase(std::remove(climbers.begin(), climbers.end(), climber), climbers.end());
}

double PlantSimulation::read_monitor(int which) const {
	double sum = 0.0;
	for (const PlantField3D *field : fields) {
		sum += field->read_monitor(which);
	}
	return sum;
}

PlantCanopy PlantSimulation::canopy_around(
		const Plant3D *plant, const Ref<PlantFunction> &species, float height) const {
	const uint64_t world = undergrowth::world_of(plant);
	for (const PlantField3D *field : fields) {
		if (undergrowth::world_of(field) == world) {
			const PlantCanopy found = field->canopy_around(plant->get_global_position(), species, height);
			if (found.height > 0.0f) {
				return found;
			}
		}
	}
	return {};
}

// Each plant in turn, so that all are visited once a second. A plant may change its group.
void PlantSimulation::shelter_plants() {
	constexpr size_t FRAMES = 60;
	std::vector<Plant3D *> due;
	const size_t count = size_t(get_plant_count());
	const size_t first = next_to_shelter < count ? next_to_shelter : 0;
	const size_t last = std::min(first + count / FRAMES + 1, count);
	size_t begin = 0;
	for (const std::unique_ptr<PlantGroup> &group : groups) {
		for (size_t i = std::max(first, begin); i < std::min(last, begin + group->plants.size()); i++) {
			due.push_back(group->plants[i - begin]);
		}
		begin += group->plants.size();
	}
	next_to_shelter = last;
	for (Plant3D *plant : due) {
		plant->update_canopy();
	}
}

void PlantSimulation::list_winds() {
	const auto list = [this](const Ref<PlantWind> &wind) {
		if (wind.is_valid() && (winds.empty() || winds.back() != wind)) {
			winds.push_back(wind);
			winds.back()->begin_frame();
		}
	};
	winds.clear();
	for (const std::unique_ptr<PlantGroup> &group : groups) {
		list(group->kind.wind);
	}
	for (const ClimberMotion *climber : climbers) {
		list(climber->wind());
	}
	for (PlantField3D *field : fields) {
		if (field->begin_frame(frame.frame)) {
			list(field->get_wind());
		}
	}
	if (!is_paused) {
		list(PlantWind::scene_wind());
	}
}

void PlantSimulation::step_groups(double ago) {
	air_sources.begin(ago);
	swings.step(clock.step());
	const FieldWind calm = { { WindKind::constant, 0.0f }, 0.0f };
	for (const std::unique_ptr<PlantGroup> &group : groups) {
		PlantWind *wind = group->kind.wind.ptr();
		group->roots.step(ago);
		group->step(wind ? wind->travelling() : calm, wind ? wind->time_before(1, clock.step()) : 0.0,
				air_sources.in(group->kind.forces.world));
	}
	for (ClimberMotion *climber : climbers) {
		PlantWind *wind = climber->wind().ptr();
		climber->step(wind ? wind->travelling() : calm, wind ? wind->time_before(1, clock.step()) : 0.0,
				air_sources.in(climber->world()));
	}
}

// Bodies and contact have no cost if no plant uses them.
void PlantSimulation::step(double ago, bool is_first) {
	const bool is_pushed = bodies.are_needed();
	if (is_pushed) {
		bodies.gather(ago);
	}
	if (is_pushed && is_first) {
		bodies.report_touches();
	}
	step_number++;
	for (Ref<PlantWind> &wind : winds) {
		wind->advance_step(step_number, clock.step());
	}
	step_groups(ago);
	if (is_pushed) {
		bodies.push();
	}
	if (contact.is_needed()) {
		contact.resolve();
	}
}

void PlantSimulation::report_warnings() {
	if (contact.is_crowded() && !has_reported_crowd) {
		has_reported_crowd = true;
		report_warning(this,
				"some contacts between plants are skipped, because too many tips are close together. Reduce "
				"collision_radius in their species, move the plants apart, or disable contact_enabled.");
	}
	for (const String &warning : bodies.take_warnings()) {
		report_warning(this, warning);
	}
}

void PlantSimulation::pose_plants() {
	const float alpha = clock.alpha();
	for (const std::unique_ptr<PlantGroup> &group : groups) {
		group->pose(alpha, swings.now(alpha));
	}
	for (ClimberMotion *climber : climbers) {
		climber->pose(alpha, swings.now(alpha));
	}
}

// A field does not wait for its last step, so `count` steps of a field take the time of one less.
void PlantSimulation::record_steps() {
	if (frame.count > 0) {
		const double plants = step_time_usec / frame.count;
		budget.record(1e-6 * (plants + field_time_usec / std::max(frame.count - 1, 1)));
	}
	field_time_usec = 0.0;
}

void PlantSimulation::advance(double delta) {
	record_steps();
	const Clock::time_point start = Clock::now();
	shelter_plants();
	drop_empty_groups();
	follow_groups();
	SceneTree *tree = Object::cast_to<SceneTree>(ObjectDB::get_instance(connected_tree));
	is_paused = tree && tree->is_paused();
	PlantWindSource3D::follow_all();
	body_readings.begin_frame(tree, delta);
	if (bodies.are_needed()) {
		bodies.watch(body_readings, delta);
	}
	for (const std::unique_ptr<PlantGroup> &group : groups) {
		group->roots.watch(group->page, delta);
	}
	const uint64_t number = frame.frame + 1;
	frame = { number, budget.allow(clock.advance(delta)), clock.step(), clock.alpha() };
	list_winds();
	for (int i = 0; i < frame.count; i++) {
		step(frame.ago(i), i == 0);
	}
	winds.clear();
	if (bodies.are_needed() || contact.is_needed()) {
		report_warnings();
	}
	step_time_usec = microseconds_since(start);
	pose_plants();
	if (const PlantWind *shown = PlantWind::scene_wind(); shown && !is_paused) {
		shown->show_in_shaders((1.0 - clock.alpha()) * clock.step());
	}
	pose_time_usec = microseconds_since(start) - step_time_usec;
}

// The signal is emitted once a frame, before any node's _process and also during a pause. Paused plants leave the
// simulation themselves.
void PlantSimulation::on_process_frame() {
	SceneTree *tree = Object::cast_to<SceneTree>(ObjectDB::get_instance(connected_tree));
	if (tree) {
		advance(tree->get_root()->get_process_delta_time());
	}
}

void PlantSimulation::follow_main_loop() {
	Engine *engine = Engine::get_singleton();
	SceneTree *tree = Object::cast_to<SceneTree>(engine->get_main_loop());
	if (PlantSimulation *simulation = get_singleton(); simulation && tree && !engine->is_editor_hint()) {
		simulation->follow(tree);
	}
}

void PlantSimulation::follow(SceneTree *tree) {
	if (tree->get_instance_id() == connected_tree) {
		return;
	}
	connected_tree = tree->get_instance_id();
	// Connects by name and not by pointer, because the connection must survive a reload of the library.
	follow_signal(tree, "process_frame", Callable(this, FRAME_METHOD));
}

int PlantSimulation::get_plant_count() const {
	int count = 0;
	for (const std::unique_ptr<PlantGroup> &group : groups) {
		count += group->page.size();
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
	// Constants are for one step length, so all plants move to pages of the new one, with their present state.
	std::vector<Plant3D *> all_plants;
	for (const std::unique_ptr<PlantGroup> &group : groups) {
		all_plants.insert(all_plants.end(), group->plants.begin(), group->plants.end());
	}
	for (Plant3D *plant : all_plants) {
		plant->leave_simulation();
	}
	drop_empty_groups();
	for (Plant3D *plant : all_plants) {
		plant->update_simulation();
	}
	for (PlantField3D *field : fields) {
		field->on_step_length_changed();
	}
	for (ClimberMotion *climber : climbers) {
		climber->set_step_length(float(clock.step()));
	}
}

void PlantSimulation::on_parts_shader_wanted() {
	load_parts_shader();
}

void PlantSimulation::on_steps_collected() {
	steps_start.begin();
	StepBatch::start_collected();
}

void PlantSimulation::_bind_methods() {
	ClassDB::bind_method(D_METHOD("_on_steps_collected"), &PlantSimulation::on_steps_collected);
	ClassDB::bind_method(D_METHOD("_add_field_time", "usec"), &PlantSimulation::add_field_time);
	ClassDB::bind_method(D_METHOD("_on_process_frame"), &PlantSimulation::on_process_frame);
	ClassDB::bind_method(D_METHOD("_load_parts_shader"), &PlantSimulation::on_parts_shader_wanted);
	ClassDB::bind_method(D_METHOD("_on_monitor_read", "which"), &PlantSimulation::read_monitor);
	ClassDB::bind_method(D_METHOD("get_plant_count"), &PlantSimulation::get_plant_count);
	ClassDB::bind_method(D_METHOD("get_step_time_usec"), &PlantSimulation::get_step_time_usec);
	ClassDB::bind_method(D_METHOD("get_pose_time_usec"), &PlantSimulation::get_pose_time_usec);
	ClassDB::bind_method(D_METHOD("get_step_length"), &PlantSimulation::get_step_length);
	ClassDB::bind_method(D_METHOD("set_step_length", "seconds"), &PlantSimulation::set_step_length);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "step_length", PROPERTY_HINT_RANGE, "0.001,0.1,0.0001,suffix:s"),
			"set_step_length", "get_step_length");
}

} // namespace undergrowth

// Plant3D: notifications of the tree, and the source of its motion.

#include "nodes/plant_3d.hpp"

#include "base/convert.hpp"
#include "base/shortest_decimal.hpp"

#include <godot_cpp/classes/engine.hpp>

#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr double MAX_STEP = 1e9; // s.
static constexpr double MAX_FRAME_TIME = 3600.0; // s.

void Plant3D::_notification(int what) {
	switch (what) {
		case NOTIFICATION_ENTER_TREE:
			set_notify_transform(true);
			update_axes();
			if (mesh_is_dirty && species.is_valid()) {
				build_mesh();
			}
			update_simulation();
			motion.pose_now(rest());
			break;
		case NOTIFICATION_POST_ENTER_TREE:
			view.find_drawn();
			update_bone();
			motion.bone().node_is_behind = true; // Outside of the tree a skeleton does not update the renderer.
			motion.pose_now(rest());
			break;
		case NOTIFICATION_EXIT_TREE:
			leave_simulation();
			forget_touches();
			break;
		case NOTIFICATION_ENTER_WORLD:
			update_forces();
			break;
		case NOTIFICATION_EXTENSION_RELOADED:
			update_axes();
			view.find_children();
			mark_dirty();
			update_simulation();
			break;
		case NOTIFICATION_CHILD_ORDER_CHANGED:
			if (view.lose_skeleton()) { // The plant is built again at the end of the frame.
				update_bone();
				mark_dirty();
			}
			break;
		case NOTIFICATION_TRANSFORM_CHANGED:
			update_axes();
			update_motion();
			break;
		case NOTIFICATION_VISIBILITY_CHANGED:
			update_bone();
			motion.pose_now(rest());
			break;
		case NOTIFICATION_PAUSED:
		case NOTIFICATION_UNPAUSED:
		case NOTIFICATION_DISABLED:
		case NOTIFICATION_ENABLED:
			update_simulation();
			break;
		default:
			break;
	}
}

void Plant3D::report_problem(const String &what) {
	if (what != problem) { // Reports each fault once for any number of builds.
		problem = what;
		report_error(this, problem);
		update_configuration_warnings();
	}
}

bool Plant3D::rebuild() {
	if (species.is_null()) {
		report_problem("cannot be built without a species. Set a PlantFunction.");
		return false;
	}
	return build_mesh();
}

bool Plant3D::build_mesh() {
	mesh_is_dirty = false;
	SampledPlant sampled;
	const String fault = species->sample(height, segments, seed, sampled);
	sampled.has_part_bones = true;
	sampled.stem = fault.is_empty() ? find_stem(sampled.height) : nullptr;
	sampled.rest = species->resting_bend();
	if (!fault.is_empty()) {
		report_problem(describe(species.ptr()) + ": " + fault);
		return false;
	}
	if (!problem.is_empty()) {
		problem = String();
		update_configuration_warnings();
	}
	view.show(sampled);
	if (Engine::get_singleton()->is_editor_hint()) {
		update_gizmos(); // They show the height and use the mesh for clicks.
	}
	update_motion();
	emit_signal("mesh_changed");
	return true;
}

Ref<ArrayMesh> Plant3D::get_mesh() {
	if (mesh_is_dirty && species.is_valid()) {
		build_mesh();
	}
	return view.get_mesh();
}

Skeleton3D *Plant3D::get_skeleton() {
	get_mesh();
	if (view.hold_skeleton()) {
		update_bone();
		motion.bone().catch_up();
	}
	return view.get_skeleton();
}

AABB Plant3D::get_reach() {
	get_mesh();
	return view.reach();
}

double Plant3D::get_plant_height() {
	get_mesh();
	return shortest_decimal(view.height());
}

void Plant3D::update_axes() {
	if (is_inside_tree()) {
		plant_transform.follow(get_global_transform());
	}
}

bool Plant3D::may_simulate() const {
	return simulation_enabled && is_inside_tree() && species.is_valid() && can_process() &&
			!Engine::get_singleton()->is_editor_hint();
}

void Plant3D::update_simulation() {
	PlantSimulation *simulation = PlantSimulation::get_singleton();
	if (simulation && may_simulate()) {
		read_canopy();
		simulation->follow(get_tree());
		motion.simulate(simulation, moved());
	} else {
		motion.park();
		bend_at_rest();
	}
	update_bone();
}

// A page of its own gives a plant that nothing moves the bend of its own weight.
void Plant3D::bend_at_rest() {
	const bool is_unmoved =
			PlantSimulation::get_singleton() && motion.is_unmoved() && species.is_valid() && !mesh_is_dirty;
	if (is_unmoved && rest().y < 1.0f && kind_of_motion().stem.nod.share > 0.0f) {
		motion.drive(moved());
	}
}

// Heights and covers in steps, so that plants of a field share pages.
void Plant3D::read_canopy() {
	constexpr float STEPS = 32.0f; // Per metre, and of a closed canopy.
	PlantSimulation *simulation = PlantSimulation::get_singleton();
	canopy = {};
	if (simulation && wind_is_air && is_inside_tree()) {
		const float tall = plant_transform.length_of(view.height());
		canopy = simulation->canopy_around(this, species, std::ceil(STEPS * tall) / STEPS);
		canopy.taller.height = std::ceil(STEPS * canopy.taller.height) / STEPS;
		canopy.taller.cover = std::round(STEPS * canopy.taller.cover) / STEPS;
	}
}

void Plant3D::update_canopy() {
	const PlantCanopy before = canopy;
	read_canopy();
	if (canopy.height != before.height || !(canopy.taller == before.taller)) {
		update_motion();
	}
}

void Plant3D::update_motion() {
	if (species.is_null()) {
		return;
	}
	if (!motion.follow(moved())) {
		update_simulation();
	}
	bend_at_rest();
	update_bone();
	if (!motion.is_simulated()) {
		motion.pose_now(rest());
	}
}

void Plant3D::update_bone() {
	motion.follow_axes(plant_transform.axes);
	const bool is_seen = is_inside_tree() && is_visible_in_tree();
	view.follow_drawn(is_seen, to_glm(plant_transform.axes.xform_inv(to_godot(rest()))));
}

void Plant3D::forget_touches() {
	if (PlantSimulation *simulation = PlantSimulation::get_singleton()) {
		simulation->forget_touches(this);
	}
}

void Plant3D::report_body(uint64_t body, bool has_entered) {
	if (Object *node = ObjectDB::get_instance(body)) {
		call_deferred("emit_signal", has_entered ? "body_entered_plants" : "body_exited_plants", node);
	}
}

// Reports the error once, and only if there is no report why the plant is missing.
bool Plant3D::can_be_driven() {
	if (species.is_valid() && get_mesh().is_valid()) {
		return true;
	}
	if (problem.is_empty()) {
		report_problem("cannot move without a plant. Set its species to a PlantFunction.");
	}
	return false;
}

void Plant3D::refuse(const String &what) {
	if (what != refusal) {
		refusal = what;
		report_error(this, what);
	}
}

void Plant3D::drive() {
	if (!motion.is_driven()) {
		motion.drive(moved());
		update_bone();
	}
}

void Plant3D::advance(double delta) {
	if (!std::isfinite(delta) || delta < 0.0 || delta > MAX_STEP) {
		refuse("advance(" + String::num(delta) + ") is invalid; nothing moved. Pass seconds of 0 or more.");
		return;
	}
	if (motion.is_simulated()) {
		refuse("advance() does nothing while the plant simulates by itself. Set simulation_enabled to false first.");
		return;
	}
	if (can_be_driven()) {
		refusal = String();
		update_wind_kind(wind);
		drive();
		motion.advance(delta, wind);
	}
}

// Called for every plant of a scene in every frame. It reports nothing if the plant cannot move: its configuration
// warning says why.
void Plant3D::preview(double delta, const Ref<PlantWind> &blowing) {
	const bool is_frame = std::isfinite(delta) && delta >= 0.0 && delta <= MAX_FRAME_TIME;
	if (is_frame && !motion.is_simulated() && species.is_valid() && get_mesh().is_valid()) {
		update_wind_kind(blowing);
		drive();
		update_canopy();
		motion.preview(delta, blowing);
	}
}

} // namespace undergrowth

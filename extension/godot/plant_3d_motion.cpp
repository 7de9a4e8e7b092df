// The part of Plant3D that moves: its place on a page, its axes and its bone.

#include "plant_3d.hpp"

#include "convert.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/world3d.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr float SHORTEST = 1e-3f; // m.
static constexpr int STATE_FLOATS = 6;

bool Plant3D::may_simulate() const {
	return simulation_enabled && is_inside_tree() && species.is_valid() && can_process() &&
			!Engine::get_singleton()->is_editor_hint();
}

static glm::vec3 to_frame(PlantFrame frame, const glm::vec3 &v) {
	return frame == PlantFrame::WORLD ? v : to_glm(axes_of(frame).xform_inv(to_godot(v)));
}

static glm::vec3 from_frame(PlantFrame frame, const glm::vec3 &v) {
	return frame == PlantFrame::WORLD ? v : to_glm(axes_of(frame).xform(to_godot(v)));
}

MotionSpecies Plant3D::motion() const {
	MotionSpecies motion;
	motion.law = Law(int(species->get_law()));
	motion.joint = species->make_joint(1.0f, Basis());
	// Plants of species that differ in it alone move alike, where nothing comes to their tips.
	const PlantPush push = what_pushes();
	motion.collision_radius = push.has_bodies() || push.has_contact() ? float(species->get_collision_radius()) : 0.0f;
	return motion;
}

PlantPush Plant3D::what_pushes() const {
	PlantPush push;
	push.bodies_group = bodies_group;
	push.touch_margin = push.has_bodies() ? float(touch_margin) : 0.0f;
	const Ref<World3D> world = contact_enabled && is_inside_tree() ? get_world_3d() : Ref<World3D>();
	push.contact_world = world.is_valid() ? uint64_t(world->get_instance_id()) : 0;
	return push;
}

MotionPlant Plant3D::description() const {
	MotionPlant plant;
	plant.root = root;
	plant.length = std::max(built_height > 0.0f ? built_height * scale_along : 1.0f, SHORTEST);
	plant.rest = to_frame(frame, to_glm(rest()));
	return plant;
}

// In world axes.
Vector3 Plant3D::rest() const {
	if (species.is_null() || species->get_law() == PlantFunction::LAW_ELASTICITY) {
		return Vector3(0.0f, 1.0f, 0.0f);
	}
	return to_godot(species->make_joint(1.0f, plant_axes).rest);
}

PlantGroup *Plant3D::page_group() const {
	return place.group ? place.group : driven ? &driven->group : nullptr;
}

PlantBone &Plant3D::bone() {
	PlantGroup *group = page_group();
	return group ? group->bones[size_t(page_index())] : own_bone;
}

Plant3D::Swing Plant3D::swing() const {
	if (const PlantGroup *group = page_group()) {
		const TipState state = group->page.state(page_index());
		return { { from_frame(group->kind.frame, state.direction), from_frame(group->kind.frame, state.rate) },
			from_frame(group->kind.frame, group->page.before(page_index())) };
	}
	const glm::vec3 calm = to_glm(rest());
	return has_swing ? parked : Swing{ { calm, {} }, calm };
}

void Plant3D::set_swing(const Swing &swing) {
	if (PlantGroup *group = page_group()) {
		const TipState &now = swing.now;
		group->page.set_state(
				page_index(), { to_frame(group->kind.frame, now.direction), to_frame(group->kind.frame, now.rate) });
		group->page.set_before(page_index(), to_frame(group->kind.frame, swing.before));
	} else {
		parked = swing;
	}
	has_swing = true;
}

void Plant3D::update_axes() {
	if (!is_inside_tree()) {
		return;
	}
	const Transform3D global = get_global_transform();
	const float along = global.basis.get_column(1).length();
	root = to_glm(global.origin);
	if (std::fabs(global.basis.determinant()) < 1e-12f || !std::isfinite(along)) {
		return; // A plant that is scaled to nothing keeps its last axes.
	}
	plant_axes = global.basis.orthonormalized();
	scale_along = along;
}

// Takes the motion out of the page that has it.
void Plant3D::park() {
	if (!page_group()) {
		return;
	}
	parked = swing();
	has_swing = true;
	own_bone = bone();
	if (place.group) {
		if (PlantSimulation *simulation = PlantSimulation::get_singleton()) {
			simulation->leave(place);
		}
		place = PlantSimulation::Place();
	}
	driven.reset();
}

void Plant3D::leave_simulation() {
	if (place.group) {
		park();
	}
}

void Plant3D::update_simulation() {
	park();
	PlantSimulation *simulation = PlantSimulation::get_singleton();
	if (!simulation || !may_simulate()) {
		update_bone();
		return;
	}
	const Swing before = swing();
	const MotionSpecies motion_now = motion();
	frame = frame_for(motion_now.law, rest());
	simulation->follow(get_tree());
	place = simulation->enter(this, { motion_now, wind, frame, what_pushes() }, description(), own_bone);
	set_swing(before);
	update_bone();
}

// Constants, axes, length or place changed: all of them the page's, or such that another page has them. The motion goes
// on either way.
void Plant3D::update_motion() {
	if (species.is_null()) {
		return;
	}
	if (PlantGroup *group = page_group()) {
		const MotionSpecies motion_now = motion();
		const bool stays = frame_for(motion_now.law, rest()) == group->kind.frame;
		const bool is_same = is_same_motion(motion_now, group->kind.species);
		if (stays && (is_same || driven)) {
			if (!is_same) {
				group->kind.species = motion_now;
				group->page.set_species(motion_now);
			}
			group->page.set_plant(page_index(), description());
		} else if (place.group) {
			update_simulation();
		} else {
			park();
		}
	}
	update_bone();
	if (!place.group) {
		pose_now();
	}
}

void Plant3D::update_bone() {
	PlantBone &shown = bone();
	const PlantGroup *group = page_group();
	const PlantBone before = shown;
	shown.skeleton = is_inside_tree() && is_visible_in_tree() ? skeleton : nullptr;
	shown.to_local = plant_axes.transposed() * axes_of(group ? group->kind.frame : PlantFrame::WORLD);
	shown.drawn = drawn.is_valid() ? drawn->get_skeleton() : RID();
	shown.is_held = skeleton_is_held;
	shown.parts = parts.get();
	shown.is_calm = !parts; // Until it was posed.
	if (parts) {
		const glm::vec3 calm = to_glm(plant_axes.xform_inv(rest()));
		parts->stem.rest = glm::vec2(calm.x, calm.z) / std::max(1.0f + calm.y, SHORTEST);
	}
	if (shown.skeleton != before.skeleton || shown.drawn != before.drawn || shown.is_held != before.is_held) {
		const bool is_unseen = drawn.is_valid() && !shown.drawn.is_valid() && !skeleton_is_held;
		shown.way = is_unseen ? PlantBone::Way::UNSEEN : PlantBone::Way::NODE; // Until the renderer has it.
	}
}

void Plant3D::pose_now() {
	const Swing now = swing();
	const PlantGroup *group = page_group();
	const PlantFrame axes = group ? group->kind.frame : PlantFrame::WORLD;
	PlantBone &shown = bone();
	if (shown.parts) {
		const float step = float(PlantSimulation::get_singleton()->get_step_length());
		shown.follow({ to_frame(axes, now.before), to_frame(axes, now.now.direction), step, parts->stem.clock });
		shown.posed = glm::vec3(NAN);
	}
	shown.turn_to(to_frame(axes, now.now.direction));
}

Vector3 Plant3D::get_tip_position() const {
	return plant_axes.xform_inv(to_godot(swing().now.direction)) * built_height;
}

double Plant3D::get_deflection() const {
	const glm::vec3 from = to_glm(rest());
	const glm::vec3 direction = swing().now.direction;
	return std::atan2(glm::length(glm::cross(from, direction)), glm::dot(from, direction));
}

void Plant3D::apply_impulse(const Vector3 &impulse) {
	if (!impulse.is_finite()) {
		report_error(this, "apply_impulse() needs a finite impulse in newton seconds.");
		return;
	}
	if (!place.group && !can_be_driven()) {
		return;
	}
	PlantGroup &group = place.group ? *place.group : prepare_driven().group;
	group.page.apply_impulse(page_index(), to_frame(group.kind.frame, to_glm(impulse)));
}

void Plant3D::reset_motion() {
	const glm::vec3 calm = to_glm(rest());
	if (place.group) {
		set_swing({ { calm, {} }, calm });
	} else {
		park();
		has_swing = false;
		own_time = 0.0;
		ear = PlantWind::Listener();
	}
	update_bone();
	pose_now();
}

PackedFloat32Array Plant3D::get_motion_state() const {
	const TipState now = swing().now;
	const Vector3 direction = plant_axes.xform_inv(to_godot(now.direction));
	const Vector3 rate = plant_axes.xform_inv(to_godot(now.rate));
	PackedFloat32Array state;
	state.resize(STATE_FLOATS);
	for (int i = 0; i < 3; i++) {
		state[i] = direction[i];
		state[3 + i] = rate[i];
	}
	return state;
}

void Plant3D::set_motion_state(const PackedFloat32Array &state) {
	const auto vector = [&state](int from) { return Vector3(state[from], state[from + 1], state[from + 2]); };
	if (state.size() != STATE_FLOATS || !vector(0).is_finite() || !vector(3).is_finite() ||
			vector(0).is_zero_approx()) {
		report_error(this,
				"set_motion_state() needs six finite numbers: the tip's direction and its rate, as get_motion_state() "
				"gives them. The motion stays as it is.");
		return;
	}
	const glm::vec3 direction = to_glm(plant_axes.xform(vector(0).normalized()));
	set_swing({ { direction, to_glm(plant_axes.xform(vector(3))) }, direction });
	pose_now();
}

} // namespace undergrowth

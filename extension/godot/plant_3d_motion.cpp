// The half of Plant3D that moves: its place in the simulation, its axes and its bone.

#include "plant_3d.hpp"

#include "convert.hpp"

#include <godot_cpp/classes/engine.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

// Below this (radians, about) a change of the pose cannot be seen and is not worth an update of the skeleton.
static constexpr float SMALLEST_TURN = 1e-6f;
// Plants that stand at more than 60° from upright are simulated in axes of their own.
static constexpr float MOST_UPRIGHT_TILT = 0.5f;
static constexpr double MOST_STEP = 1e9; // s.
static constexpr int MOST_STEPS_OF_CALL = 128;

bool Plant3D::may_simulate() const {
	return simulating && is_inside_tree() && function.is_valid() && can_process() &&
			!Engine::get_singleton()->is_editor_hint();
}

// The spring law lives on the half sphere above the root, so a plant on a wall or a ceiling needs tilted axes.
static Basis frame_of(const Basis &axes, Law law) {
	const Vector3 up = axes.get_column(1);
	if (law == Law::elasticity || up.y > MOST_UPRIGHT_TILT) {
		return Basis();
	}
	const Vector3 world_up(0.0f, 1.0f, 0.0f);
	if (up.y < -0.9999f) {
		return Basis(Vector3(1.0f, 0.0f, 0.0f), float(PI));
	}
	return Basis(Quaternion(world_up, up));
}

void Plant3D::update_axes() {
	if (!is_inside_tree()) {
		return;
	}
	const Basis global = get_global_transform().basis;
	const float along = global.get_column(1).length();
	if (std::fabs(global.determinant()) < 1e-12f || !std::isfinite(along)) {
		return; // A plant that is scaled to nothing keeps its last axes.
	}
	plant_axes = global.orthonormalized();
	scale_along = along;
	const Law law = function.is_valid() ? Law(int(function->get_law())) : Law::spring;
	const Basis new_frame = frame_of(plant_axes, law);
	const bool moves_over = !(new_frame == frame) && place.group;
	to_local = plant_axes.transposed() * new_frame;
	if (moves_over || !(new_frame == frame)) {
		park();
		state.direction = to_glm(new_frame.xform_inv(frame.xform(to_godot(state.direction))));
		state.rate = to_glm(new_frame.xform_inv(frame.xform(to_godot(state.rate))));
		frame = new_frame;
		update_simulation();
	}
}

Joint Plant3D::joint() const {
	const float length = std::max(built_height > 0.0f ? built_height * scale_along : 1.0f, 1e-3f);
	return function->make_joint(length, frame.transposed() * plant_axes);
}

glm::vec3 Plant3D::rest() const {
	if (function.is_null() || function->get_law() == PlantFunction::LAW_ELASTICITY) {
		return { 0.0f, 1.0f, 0.0f };
	}
	return joint().rest;
}

TipState Plant3D::current_state() const {
	if (place.group) {
		return place.group->batch.state(place.index);
	}
	if (own) {
		return own->batch.state(0);
	}
	if (has_state) {
		return state;
	}
	TipState at_rest;
	at_rest.direction = rest();
	return at_rest;
}

// Takes the state out of the batch that has it.
void Plant3D::park() {
	state = current_state();
	has_state = has_state || place.group || own;
	if (place.group) {
		if (PlantSimulation *simulation = PlantSimulation::get_singleton()) {
			simulation->leave(place);
		}
		place = PlantSimulation::Place();
	}
	own.reset();
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
		return;
	}
	simulation->follow(get_tree());
	place = simulation->enter(this, Law(int(function->get_law())), wind, frame, joint(), state);
	has_state = true;
}

// Constants changed: the law may have, too, which takes the plant to another batch. Its motion goes on either way.
void Plant3D::update_joint() {
	if (function.is_null()) {
		return;
	}
	if (PlantGroup *group = place.group ? place.group : own.get()) {
		if (group->batch.law() == Law(int(function->get_law()))) {
			group->batch.set_joint(place.group ? place.index : 0, joint());
		} else {
			update_axes();
			update_simulation();
		}
	}
	if (!place.group) {
		pose_now();
	}
}

// Told once, and not at all to those who know already why there is no plant.
bool Plant3D::can_be_driven() {
	if (function.is_valid() && get_mesh().is_valid()) {
		return true;
	}
	if (problem.is_empty()) {
		report_problem("cannot move without a plant. Set a PlantFunction.");
	}
	return false;
}

void Plant3D::refuse(const String &what) {
	if (what != refusal) {
		refusal = what;
		report_error(this, what);
	}
}

PlantGroup *Plant3D::prepare_own_group() {
	const float step_length = float(PlantSimulation::get_singleton()->get_step_length());
	const Law law = Law(int(function->get_law()));
	if (own && (own->batch.law() != law || own->batch.step_length() != step_length)) {
		park();
	}
	if (!own) {
		const TipState start = current_state();
		own = std::make_unique<PlantGroup>(law, step_length, wind, frame);
		own->batch.add(joint(), start);
		const double length = PlantSimulation::get_singleton()->get_step_length();
		own_clock = std::make_unique<FixedStep>(length, MOST_STEPS_OF_CALL);
	}
	return own.get();
}

void Plant3D::step(double delta) {
	if (!std::isfinite(delta) || delta < 0.0 || delta > MOST_STEP) {
		refuse("step(" + String::num(delta) + ") is impossible; nothing moved. Pass seconds of 0 or more.");
		return;
	}
	if (place.group) {
		refuse("step() does nothing while the plant simulates by itself. Set simulating to false first.");
		return;
	}
	if (!can_be_driven()) {
		return;
	}
	refusal = String();
	PlantGroup *group = prepare_own_group();
	for (int steps = own_clock->advance(delta); steps > 0; steps--) {
		own_time += own_clock->step();
		const Vector3 force = wind.is_valid() ? wind->sample(own_time) : Vector3();
		group->batch.step(to_glm(frame.xform_inv(force)));
	}
	if (wind.is_valid()) {
		wind->keep_up_with(own_time);
	}
	glm::vec3 direction;
	group->batch.interpolate(own_clock->alpha(), &direction);
	pose(direction);
}

void Plant3D::pose_now() {
	pose(current_state().direction);
}

// The shortest turn from +Y to d = (x, y, z): axis (z, 0, -x), half-angle form (1 + y, axis)/norm.
static Quaternion turn_from_up(const glm::vec3 &d) {
	const float w = 1.0f + d.y;
	if (w < 1e-6f) {
		return Quaternion(1.0f, 0.0f, 0.0f, 0.0f);
	}
	const float scale = 1.0f / std::sqrt(w * w + d.x * d.x + d.z * d.z);
	return Quaternion(d.z * scale, 0.0f, -d.x * scale, w * scale);
}

void Plant3D::pose(const glm::vec3 &direction) {
	if (!skeleton || !is_shown) {
		return;
	}
	const glm::vec3 local = to_glm(to_local.xform(to_godot(direction)));
	const glm::vec3 change = glm::abs(local - posed);
	if (change.x < SMALLEST_TURN && change.y < SMALLEST_TURN && change.z < SMALLEST_TURN) {
		return;
	}
	posed = local;
	skeleton->set_bone_pose_rotation(1, turn_from_up(local));
}

Vector3 Plant3D::get_tip_position() const {
	return to_local.xform(to_godot(current_state().direction)) * built_height;
}

double Plant3D::get_deflection() const {
	const glm::vec3 from = rest();
	const glm::vec3 direction = current_state().direction;
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
	PlantGroup *group = place.group ? place.group : prepare_own_group();
	group->batch.apply_impulse(place.group ? place.index : 0, to_glm(frame.xform_inv(impulse)));
}

void Plant3D::reset() {
	TipState at_rest;
	at_rest.direction = rest();
	if (place.group) {
		place.group->batch.set_state(place.index, at_rest);
	} else {
		own.reset();
		has_state = false;
		own_time = 0.0;
	}
	pose(at_rest.direction);
}

} // namespace undergrowth

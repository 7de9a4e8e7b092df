// What moves a Plant3D by hand: advance() in games, preview() in the editor, each on a page of the plant's own.

#include "plant_3d.hpp"

#include <godot_cpp/classes/engine.hpp>

#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr double MOST_STEP = 1e9; // s.
static constexpr double MOST_FRAME = 3600.0; // s.

// Told once, and not at all to those who know already why there is no plant.
bool Plant3D::can_be_driven() {
	if (species.is_valid() && get_mesh().is_valid()) {
		return true;
	}
	if (problem.is_empty()) {
		report_problem("cannot move without a plant. Set its Species to a PlantFunction.");
	}
	return false;
}

void Plant3D::refuse(const String &what) {
	if (what != refusal) {
		refusal = what;
		report_error(this, what);
	}
}

Plant3D::Driven &Plant3D::prepare_driven() {
	const double step_length = PlantSimulation::get_singleton()->get_step_length();
	if (driven && driven->clock.step() != step_length) {
		park();
	}
	if (!driven) {
		const Swing before = swing();
		const MotionSpecies motion_now = motion();
		frame = frame_for(motion_now.law, rest());
		std::unique_ptr<Driven> made = std::make_unique<Driven>(PlantKind{ motion_now, {}, frame, {} }, step_length);
		const MotionPlant plant = description();
		made->group.add(this, plant, own_bone);
		driven = std::move(made);
		set_swing(before);
		update_bone();
	}
	return *driven;
}

void Plant3D::advance(double delta) {
	if (!std::isfinite(delta) || delta < 0.0 || delta > MOST_STEP) {
		refuse("advance(" + String::num(delta) + ") is impossible; nothing moved. Pass seconds of 0 or more.");
		return;
	}
	if (place.group) {
		refuse("advance() does nothing while the plant simulates by itself. Set simulation_enabled to false first.");
		return;
	}
	if (!can_be_driven()) {
		return;
	}
	refusal = String();
	Driven &own = prepare_driven();
	FieldWind air = { { WindKind::constant, 0.0f }, 0.0f };
	if (wind.is_valid()) {
		air = wind->heard_by(ear, own_time);
	}
	for (int steps = own.clock.advance(delta); steps > 0; steps--) {
		own.group.step(air, own_time);
		own.swings.step(own.clock.step());
		own_time += own.clock.step();
	}
	if (wind.is_valid()) {
		wind->keep_up_with(own_time);
	}
	own.group.pose(own.clock.alpha(), own.swings.now(own.clock.alpha()));
}

// Called for every plant of a scene and every frame. What cannot move stays still without a word: its configuration
// warning tells why.
void Plant3D::preview(double delta, const Ref<PlantWind> &blowing) {
	const bool is_frame = std::isfinite(delta) && delta >= 0.0 && delta <= MOST_FRAME;
	if (!is_frame || place.group || species.is_null() || !get_mesh().is_valid()) {
		return;
	}
	Driven &own = prepare_driven();
	FieldWind air = { { WindKind::constant, 0.0f }, 0.0f };
	double time = 0.0;
	if (blowing.is_valid()) {
		air = blowing->travelling();
		time = blowing->get_time() - delta;
	}
	for (int steps = own.clock.advance(delta); steps > 0; steps--) {
		own.group.step(air, time);
		own.swings.step(own.clock.step());
		time += own.clock.step();
	}
	own.group.pose(own.clock.alpha(), own.swings.now(own.clock.alpha()));
}

void Plant3D::on_wind_changed() {
	if (Engine::get_singleton()->is_editor_hint()) {
		update_configuration_warnings();
		update_gizmos(); // They show the wind's direction.
	}
}

} // namespace undergrowth

#include "plants/plant_motion.hpp"

#include "base/convert.hpp"

using namespace godot;

namespace undergrowth {

static const FieldWind CALM_AIR = { { WindKind::constant, 0.0f }, 0.0f };

static glm::vec3 to_frame(PlantFrame frame, const glm::vec3 &v) {
	return frame == PlantFrame::WORLD ? v : to_glm(axes_of(frame).xform_inv(to_godot(v)));
}

static glm::vec3 from_frame(PlantFrame frame, const glm::vec3 &v) {
	return frame == PlantFrame::WORLD ? v : to_glm(axes_of(frame).xform(to_godot(v)));
}

static PlantFrame frame_of(const MovedPlant &moved) {
	return frame_for(moved.species.law, to_godot(moved.rest));
}

static MotionPlant row_of(const MovedPlant &moved, PlantFrame frame) {
	MotionPlant row;
	row.root = moved.root;
	row.length = moved.length;
	row.rest = to_frame(frame, moved.rest);
	row.scale = moved.scale;
	row.own = moved.own;
	return row;
}

PlantGroup *PlantMotion::group() const {
	return place.group ? place.group : driven ? &driven->group : nullptr;
}

PlantFrame PlantMotion::frame() const {
	const PlantGroup *in = group();
	return in ? in->kind.frame : PlantFrame::WORLD;
}

PlantBone &PlantMotion::bone() {
	PlantGroup *in = group();
	return in ? in->bones[size_t(index())] : own_bone;
}

PlantMotionState PlantMotion::motion_state(const glm::vec3 &rest) const {
	if (const PlantGroup *in = group()) {
		const MotionPage &page = in->page;
		const TipState state = page.state(index());
		PlantMotionState motion_state = { { from_frame(frame(), state.direction), from_frame(frame(), state.rate) },
			from_frame(frame(), page.before(index())) };
		const StemSecond second = page.second(index());
		motion_state.second = { from_frame(frame(), second.bend), from_frame(frame(), second.rate) };
		if (page.law() == Law::stem) {
			motion_state.stem = { frame(), page.stem_constants().modes, page.stem(index()), page.stem_before(index()),
				page.lasting_bend(index()) };
		}
		return motion_state;
	}
	return parked.value_or(PlantMotionState::at_rest(rest));
}

void PlantMotion::set_motion_state(const PlantMotionState &motion_state) {
	if (PlantGroup *in = group()) {
		MotionPage &page = in->page;
		const PlantMotionState::Stem *stem = motion_state.stem ? &*motion_state.stem : nullptr;
		if (stem && frame() == stem->frame) {
			page.set_lasting_bend(index(), stem->lasting);
		}
		if (stem && page.law() == Law::stem && page.stem_constants().modes == stem->modes && frame() == stem->frame) {
			page.set_stem(index(), stem->now);
			page.set_stem_before(index(), stem->before);
			return;
		}
		const StemSecond second = { to_frame(frame(), motion_state.second.bend),
			to_frame(frame(), motion_state.second.rate) };
		page.set_state(index(),
				{ to_frame(frame(), motion_state.now.direction), to_frame(frame(), motion_state.now.rate) }, second);
		page.set_before(index(), to_frame(frame(), motion_state.before));
	} else {
		parked = motion_state;
	}
}

void PlantMotion::park() {
	if (!group()) {
		return;
	}
	parked.reset();
	MotionPage &page = group()->page;
	if (page.stem_constants().nod.share == 0.0f || !page.is_at_rest(index())) {
		parked = motion_state({});
	}
	own_bone = bone();
	if (place.group) {
		if (PlantSimulation *simulation = PlantSimulation::get_singleton()) {
			simulation->leave(place);
		}
		place = PlantSimulation::Place();
	}
	driven.reset();
}

void PlantMotion::leave_simulation() {
	if (place.group) {
		park();
	}
}

void PlantMotion::simulate(PlantSimulation *simulation, const MovedPlant &moved) {
	park();
	const PlantFrame axes = frame_of(moved);
	place = simulation->enter(
			plant, { moved.species, moved.wind, axes, moved.forces, moved.taller }, row_of(moved, axes), own_bone);
	if (parked) {
		set_motion_state(*parked);
	}
}

bool PlantMotion::is_driven() const {
	return driven && driven->step_length() == PlantSimulation::get_singleton()->get_step_length();
}

void PlantMotion::drive(const MovedPlant &moved) {
	park();
	const PlantFrame axes = frame_of(moved);
	ForceSettings forces;
	forces.world = moved.forces.world;
	driven = std::make_unique<DrivenPlant>(PlantKind{ moved.species, {}, axes, forces, moved.taller },
			PlantSimulation::get_singleton()->get_step_length());
	driven->group.add(plant, row_of(moved, axes), own_bone);
	if (parked) {
		set_motion_state(*parked);
	}
}

void PlantMotion::advance(double delta, const Ref<PlantWind> &wind) {
	driven->advance(delta, wind.is_valid() ? wind->for_listener(gust_listener, own_time) : CALM_AIR, own_time);
	if (wind.is_valid()) {
		wind->catch_up_to(own_time);
	}
}

void PlantMotion::preview(double delta, const Ref<PlantWind> &blowing) {
	double time = blowing.is_valid() ? blowing->get_time() - delta : 0.0;
	driven->advance(delta, blowing.is_valid() ? blowing->travelling() : CALM_AIR, time);
}

bool PlantMotion::follow(const MovedPlant &moved) {
	PlantGroup *in = group();
	if (!in) {
		return true;
	}
	const bool stays = frame_of(moved) == in->kind.frame;
	const bool is_same = is_same_motion(moved.species, in->kind.species) && moved.taller == in->kind.taller;
	if (stays && (is_same || driven)) {
		if (driven) {
			in->kind.forces.world = moved.forces.world;
		}
		if (!is_same) {
			in->kind.species = moved.species;
			in->kind.taller = moved.taller;
			in->page.set_species(moved.species);
			in->page.set_taller_plants(moved.taller);
		}
		in->page.set_plant(index(), row_of(moved, in->kind.frame));
		return true;
	}
	if (driven) {
		park();
	}
	return !place.group;
}

void PlantMotion::reset() {
	if (place.group) {
		place.group->page.settle(index());
	} else {
		park();
		parked.reset();
		own_time = 0.0;
		forget_wind();
	}
}

void PlantMotion::apply_impulse(const glm::vec3 &impulse) {
	if (PlantGroup *in = group()) {
		in->page.apply_impulse(index(), to_frame(frame(), impulse));
	}
}

void PlantMotion::apply_impulse_at(int joint, const glm::vec3 &impulse) {
	if (PlantGroup *in = group()) {
		in->page.apply_impulse_at(index(), joint, to_frame(frame(), impulse));
	}
}

bool PlantMotion::find_arm(float share, glm::vec3 &arm) const {
	const PlantGroup *in = group();
	if (in) {
		arm = from_frame(frame(), in->page.arm(index(), share)) / in->page.length(index());
	}
	return in != nullptr;
}

void PlantMotion::follow_axes(const Basis &axes) {
	bone().to_local = axes.transposed() * axes_of(frame());
}

void PlantMotion::pose_now(const glm::vec3 &rest) {
	const PlantMotionState now = motion_state(rest);
	const glm::vec3 direction = to_frame(frame(), now.now.direction);
	PlantBone &shown = bone();
	if (shown.parts) {
		const float step = float(PlantSimulation::get_singleton()->get_step_length());
		const PlantGroup *in = group();
		const glm::vec3 second = in ? in->page.second_bend(index(), 1.0f) : shown.second_bend(now.now, now.second);
		shown.follow({ to_frame(frame(), now.before), direction, step, shown.parts->stem.clock, second });
		shown.posed = glm::vec3(NAN);
	}
	shown.turn_to(direction);
}

} // namespace undergrowth

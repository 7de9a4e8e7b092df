// Plant3D: properties, and their effect on its components.

#include "nodes/plant_3d.hpp"

#include "base/convert.hpp"
#include "base/follow_changes.hpp"
#include "base/random.hpp"
#include "base/world_of.hpp"
#include "plant/base_shape.hpp"

#include <godot_cpp/classes/engine.hpp>

using namespace godot;

namespace undergrowth {

static constexpr Range SEGMENTS_RANGE = { MIN_LOD, MAX_LOD };
static constexpr Range HEIGHT_RANGE = { 0.0, 1000.0 };
static constexpr Range MARGIN_RANGE = { 0.0, 100.0 };
static constexpr float MIN_SCALE = 1e-6f;
static constexpr Range APPARENT_RANGE = { 0.0, 10.0 };

void Plant3D::set_species(const Ref<PlantFunction> &new_species) {
	if (new_species == species) {
		return;
	}
	const Callable changed(this, "_on_species_changed");
	unfollow_changes(species.ptr(), changed);
	if (new_species.is_null()) {
		report_problem("has no species; the last plant stays. Set its species to a PlantFunction.");
	}
	species = new_species;
	follow_changes(species.ptr(), changed);
	if (species.is_valid()) {
		mark_dirty();
		update_simulation();
	}
	update_configuration_warnings();
}

Ref<PlantFunction> Plant3D::get_species() const {
	return species;
}

void Plant3D::set_wind(const Ref<PlantWind> &new_wind) {
	if (new_wind == wind) {
		return;
	}
	const Callable changed(this, "_on_wind_changed");
	unfollow_changes(wind.ptr(), changed);
	wind = new_wind;
	follow_changes(wind.ptr(), changed);
	motion.forget_wind();
	update_wind_kind(wind);
	if (motion.is_simulated()) {
		update_simulation();
	}
	on_wind_changed();
}

Ref<PlantWind> Plant3D::get_wind() const {
	return wind;
}

void Plant3D::set_segments(int count) {
	if (count != segments && accept_value(this, "segments", count, SEGMENTS_RANGE)) {
		segments = count;
		mark_dirty();
	}
}

int Plant3D::get_segments() const {
	return segments;
}

void Plant3D::set_height(double metres) {
	if (metres != height && accept_value(this, "height", metres, HEIGHT_RANGE)) {
		height = metres;
		mark_dirty();
	}
}

double Plant3D::get_height() const {
	return height;
}

void Plant3D::set_seed(int64_t new_seed) {
	if (new_seed != seed) {
		seed = new_seed;
		mark_dirty();
	}
}

int64_t Plant3D::get_seed() const {
	return seed;
}

void Plant3D::set_simulation_enabled(bool enabled) {
	if (enabled != simulation_enabled) {
		simulation_enabled = enabled;
		update_simulation();
	}
}

bool Plant3D::is_simulation_enabled() const {
	return simulation_enabled;
}

void Plant3D::set_contact_enabled(bool on) {
	contact_enabled = on;
	update_forces();
}

bool Plant3D::is_contact_enabled() const {
	return contact_enabled;
}

void Plant3D::set_bodies_group(const StringName &group) {
	bodies_group = group;
	update_forces();
}

StringName Plant3D::get_bodies_group() const {
	return bodies_group;
}

void Plant3D::set_touch_margin(double metres) {
	if (accept_value(this, "touch_margin", metres, MARGIN_RANGE)) {
		touch_margin = metres;
		update_forces();
	}
}

double Plant3D::get_touch_margin() const {
	return touch_margin;
}

void Plant3D::set_apparent_wind(double share) {
	if (accept_value(this, "apparent_wind", share, APPARENT_RANGE)) {
		apparent_wind = share;
		update_forces();
	}
}

double Plant3D::get_apparent_wind() const {
	return apparent_wind;
}

// Plants with the same pushes share a page.
void Plant3D::update_forces() {
	if (motion.has_other_forces(force_settings())) {
		update_simulation();
	}
}

std::shared_ptr<const StemConstants> Plant3D::find_stem(float metres) const {
	return species->find_stem(metres, wind_is_air);
}

MotionSpecies Plant3D::kind_of_motion() const {
	MotionSpecies kind;
	kind.law = Law(int(species->get_law()));
	kind.joint = species->make_joint(Basis());
	kind.canopy_height = canopy.height;
	if (const std::shared_ptr<const StemConstants> stem = find_stem(view.height())) {
		kind.stem = *stem;
	}
	kind.trampling = species->make_trampling();
	// The radius has an effect on tips with contact only. Without contact, plants of species with different radii share
	// a page.
	const ForceSettings forces = force_settings();
	kind.collision_radius = forces.has_bodies() || forces.has_contact ? float(species->get_collision_radius()) : 0.0f;
	return kind;
}

ForceSettings Plant3D::force_settings() const {
	ForceSettings forces;
	forces.bodies_group = bodies_group;
	forces.touch_margin = forces.has_bodies() ? float(touch_margin) : 0.0f;
	forces.world = world_of(this);
	forces.has_contact = contact_enabled && forces.world != 0;
	forces.apparent_wind = float(apparent_wind);
	return forces;
}

// Returns the rest direction in world axes.
glm::vec3 Plant3D::rest() const {
	if (species.is_null() || species->get_law() == PlantFunction::LAW_ELASTICITY) {
		return { 0.0f, 1.0f, 0.0f };
	}
	return species->make_joint(plant_transform.axes).rest;
}

MovedPlant Plant3D::moved() const {
	return { kind_of_motion(), wind, force_settings(), plant_transform.root, rest(),
		plant_transform.length_of(view.height()), std::max(plant_transform.scale_along, MIN_SCALE),
		signed_noise(uint64_t(seed), 0), canopy.taller };
}

// Many properties may change in one frame. The mesh is built once, at the end of the frame.
void Plant3D::mark_dirty() {
	mesh_is_dirty = true;
	if (is_inside_tree()) {
		rebuild_call.queue();
	}
}

void Plant3D::on_rebuild_queued() {
	rebuild_call.begin();
	if (mesh_is_dirty && species.is_valid()) {
		build_mesh();
	}
}

void Plant3D::on_species_changed() {
	if (species.is_null()) {
		return; // After a reload of the library, before the engine has set the species again.
	}
	const bool is_drawn_so = species->is_motion_change() && !view.rests_elsewhere(species->resting_bend());
	if (is_drawn_so && view.follow_stem(find_stem(view.height()))) {
		update_motion();
	} else {
		mark_dirty();
	}
	update_configuration_warnings();
}

// A wind in m/s bends a stem to another shape than a force in newtons.
void Plant3D::update_wind_kind(const Ref<PlantWind> &blowing) {
	if (PlantWind::is_air(blowing) == wind_is_air) {
		return;
	}
	wind_is_air = !wind_is_air;
	if (species.is_valid() && species->get_law() == PlantFunction::LAW_STEM && !mesh_is_dirty) {
		view.follow_stem(find_stem(view.height()));
		update_motion();
	}
}

void Plant3D::on_wind_changed() {
	update_wind_kind(wind);
	if (Engine::get_singleton()->is_editor_hint()) {
		update_configuration_warnings();
		update_gizmos(); // They show the direction of the wind.
	}
}

PackedStringArray Plant3D::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (species.is_null()) {
		warnings.push_back("This plant needs a species: set Species to a PlantFunction, such as a TulipFunction.");
	} else if (!problem.is_empty()) {
		warnings.push_back(problem);
	}
	if (wind.is_valid() && wind->get_strength() == 0.0) {
		warnings.push_back(
				"The wind has a strength of 0 N, so this plant does not move: increase Strength of its Wind.");
	}
	return warnings;
}

} // namespace undergrowth

// Plant3D's properties and its life in the tree. plant_3d_mesh.cpp builds what is drawn, plant_3d_motion.cpp,
// plant_3d_driving.cpp and plant_3d_pushes.cpp move it.

#include "plant_3d.hpp"

#include "follow_changes.hpp"
#include "plant/base_shape.hpp"

#include <godot_cpp/classes/engine.hpp>

using namespace godot;

namespace undergrowth {

static constexpr Range SEGMENTS_RANGE = { MIN_LOD, MAX_LOD };
static constexpr Range HEIGHT_RANGE = { 0.0, 1000.0 };

Plant3D::~Plant3D() {
	leave_simulation();
}

void Plant3D::set_species(const Ref<PlantFunction> &new_species) {
	if (new_species == species) {
		return;
	}
	const Callable changed(this, "_on_species_changed");
	unfollow_changes(species.ptr(), changed);
	if (new_species.is_null()) {
		report_problem("has no species any more; the last plant stays. Set its Species to a PlantFunction.");
	}
	species = new_species;
	follow_changes(species.ptr(), changed);
	if (species.is_valid()) {
		mark_stale();
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
	ear = PlantWind::Listener();
	if (place.group) {
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
		mark_stale();
	}
}

int Plant3D::get_segments() const {
	return segments;
}

void Plant3D::set_height(double metres) {
	if (metres != height && accept_value(this, "height", metres, HEIGHT_RANGE)) {
		height = metres;
		mark_stale();
	}
}

double Plant3D::get_height() const {
	return height;
}

void Plant3D::set_seed(int64_t new_seed) {
	if (new_seed != seed) {
		seed = new_seed;
		mark_stale();
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

void Plant3D::on_species_changed() {
	if (species.is_null()) {
		return; // The library was reloaded, and the engine has not set it again yet.
	}
	if (species->is_motion_change()) {
		update_motion();
	} else {
		mark_stale();
	}
	update_configuration_warnings();
}

PackedStringArray Plant3D::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (species.is_null()) {
		warnings.push_back("This plant needs a species: set Species to a PlantFunction, such as a TulipFunction.");
	} else if (!problem.is_empty()) {
		warnings.push_back(problem);
	}
	if (wind.is_valid() && wind->get_strength() == 0.0) {
		warnings.push_back("The wind has a strength of 0 N, so this plant stands still: raise Strength in its Wind.");
	}
	return warnings;
}

void Plant3D::_notification(int what) {
	switch (what) {
		case NOTIFICATION_ENTER_TREE:
			set_notify_transform(true);
			update_axes();
			if (mesh_is_stale && species.is_valid()) {
				build_mesh();
			}
			update_simulation();
			pose_now();
			break;
		case NOTIFICATION_POST_ENTER_TREE:
			find_drawn();
			bone().node_is_behind = true; // Outside of the tree a skeleton keeps its pose to itself.
			pose_now();
			break;
		case NOTIFICATION_EXIT_TREE:
			leave_simulation();
			forget_touches();
			break;
		case NOTIFICATION_ENTER_WORLD:
			change_pushes();
			break;
		case NOTIFICATION_EXTENSION_RELOADED:
			update_axes();
			find_children();
			mark_stale();
			update_simulation();
			break;
		case NOTIFICATION_CHILD_ORDER_CHANGED:
			lose_skeleton();
			break;
		case NOTIFICATION_TRANSFORM_CHANGED:
			update_axes();
			update_motion();
			break;
		case NOTIFICATION_VISIBILITY_CHANGED:
			update_bone();
			pose_now();
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

} // namespace undergrowth

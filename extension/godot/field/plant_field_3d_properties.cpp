// What users set of a PlantField3D, and how scripts and the inspector see it.

#include "field/plant_field_3d.hpp"

#include "as_written.hpp"
#include "follow_changes.hpp"
#include "species_functions.hpp"

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

namespace undergrowth {

void PlantField3D::changed(About about) {
	if (about == About::stand) {
		mark_stale(true);
	} else if (about == About::view && !meadow.update_levels()) {
		mark_stale(false);
	}
}

void PlantField3D::set_number(double &slot, const char *name, double value, const Range &range, About about) {
	if (accept_value(this, name, value, range) && value != slot) {
		slot = value;
		changed(about);
	}
}

void PlantField3D::set_whole(int &slot, const char *name, int value, const Range &range, About about) {
	if (accept_value(this, name, value, range) && value != slot) {
		slot = value;
		changed(about);
	}
}

// From x to y.
void PlantField3D::set_span(Vector2 &slot, const char *name, const Vector2 &value, const Range &range) {
	if (!accept_value(this, name, value.x, range) || !accept_value(this, name, value.y, range)) {
		return;
	}
	if (value.y < value.x) {
		report_error(this,
				String(name) + " goes from " + String::num(value.x) + " down to " + String::num(value.y) +
						", it keeps its value. Set the smaller number first.");
	} else if (value != slot) {
		slot = value;
		changed(About::stand);
	}
}

#define FIELD_NUMBER(m_name, m_slot, m_least, m_most, m_about)                                                         \
	void PlantField3D::set_##m_name(double value) {                                                                    \
		set_number(properties.m_slot, #m_name, value, { m_least, m_most }, About::m_about);                            \
	}
#define FIELD_WHOLE(m_name, m_slot, m_least, m_most, m_about)                                                          \
	void PlantField3D::set_##m_name(int value) {                                                                       \
		set_whole(properties.m_slot, #m_name, value, { m_least, m_most }, About::m_about);                             \
	}

FIELD_NUMBER(density, stand.density, 0.0, 10000.0, stand)
FIELD_NUMBER(clumping, stand.clumping, 0.0, 1.0, stand)
FIELD_NUMBER(clump_size, stand.clump_size, 0.01, 1000.0, stand)
FIELD_NUMBER(slope_alignment, stand.slope_alignment, 0.0, 1.0, stand)
FIELD_NUMBER(far_distance, motion.far_distance, 0.0, 1e6, nothing)
FIELD_NUMBER(touch_margin, motion.touch_margin, 0.0, 100.0, nothing)
FIELD_WHOLE(max_threads, motion.max_threads, 0, 256, nothing)
FIELD_NUMBER(fade_margin, view.fade_margin, 0.0, 1000.0, view)
FIELD_NUMBER(shadow_distance, view.shadow_distance, 0.0, 1e6, view)

#undef FIELD_NUMBER
#undef FIELD_WHOLE

void PlantField3D::set_tile_size(double metres) {
	const double before = properties.view.tile_size;
	set_number(properties.view.tile_size, "tile_size", metres, { 1.0, 1000.0 }, About::nothing);
	if (properties.view.tile_size != before) {
		mark_stale(false);
	}
}

void PlantField3D::set_skeleton_distance(double metres) {
	set_number(properties.view.skeleton_distance, "skeleton_distance", metres, { 0.0, 1e6 }, About::nothing);
	meadow.skeletons_changed();
}

void PlantField3D::set_max_skeletons(int count) {
	set_whole(properties.view.max_skeletons, "max_skeletons", count, { 0, 1024 }, About::nothing);
	meadow.skeletons_changed();
}

void PlantField3D::set_update_interval(int step_count) {
	set_whole(properties.motion.update_interval, "update_interval", step_count, { 1, 64 }, About::nothing);
	meadow.motion.set_update_interval(properties.motion.update_interval);
}

void PlantField3D::set_prototypes(int count) {
	const int before = properties.motion.prototypes;
	set_whole(properties.motion.prototypes, "prototypes", count, { 0, 64 }, About::nothing);
	if (properties.motion.prototypes != before) {
		mark_stale(false);
		update_configuration_warnings();
	}
}

void PlantField3D::set_contact_enabled(bool on) {
	properties.motion.contact_enabled = on;
	update_configuration_warnings();
	meadow.motion.fit_contact(on);
}

void PlantField3D::set_simulation_enabled(bool on) {
	properties.motion.simulation_enabled = on;
	if (!on) {
		meadow.refresh(); // What it was the last to do is seen, too.
	}
}

void PlantField3D::set_bodies_group(const StringName &group) {
	properties.motion.bodies_group = group;
}

void PlantField3D::set_wind(const Ref<PlantWind> &wind) {
	const Callable listener(this, "_on_wind_changed");
	unfollow_changes(properties.motion.wind.ptr(), listener);
	properties.motion.wind = wind;
	follow_changes(properties.motion.wind.ptr(), listener);
	update_configuration_warnings();
}

void PlantField3D::set_seed(int64_t seed) {
	if (seed != properties.stand.seed) {
		properties.stand.seed = seed;
		mark_stale(true);
	}
}

void PlantField3D::set_size(const Vector2 &metres) {
	static constexpr Range SIZE_RANGE = { 0.0, 1e5 };
	if (accept_value(this, "size", metres.x, SIZE_RANGE) && accept_value(this, "size", metres.y, SIZE_RANGE) &&
			metres != properties.stand.size) {
		properties.stand.size = metres;
		mark_stale(true);
		update_gizmos();
	}
}

void PlantField3D::set_outline(const NodePath &path) {
	properties.stand.outline = path;
	notify_property_list_changed();
	mark_stale(true);
	update_gizmos();
}

void PlantField3D::set_exclusions(const TypedArray<NodePath> &paths) {
	properties.stand.exclusions = paths.duplicate();
	seen_exclusions = paths.duplicate();
	mark_stale(true);
}

void PlantField3D::set_ground_mode(GroundMode mode) {
	if (mode < GROUND_NONE || mode > GROUND_MESH) {
		report_error(
				this, "ground_mode " + String::num_int64(mode) + " does not exist. Use one of the GROUND_ constants.");
	} else if (int(mode) != properties.stand.ground_mode) {
		properties.stand.ground_mode = int(mode);
		notify_property_list_changed();
		mark_stale(true);
	}
}

void PlantField3D::set_ground_collision_mask(int64_t mask) {
	if (mask != properties.stand.ground_collision_mask) {
		properties.stand.ground_collision_mask = mask;
		mark_stale(true);
	}
}

void PlantField3D::set_ground_mesh(const NodePath &path) {
	properties.stand.ground_mesh = path;
	mark_stale(true);
}

void PlantField3D::set_height_limits(const Vector2 &metres) {
	set_span(properties.stand.height_limits, "height_limits", metres, { -1e6, 1e6 });
}

void PlantField3D::set_slope_limits(const Vector2 &radians) {
	set_span(properties.stand.slope_limits, "slope_limits", radians, { 0.0, 3.1415928 });
}

Vector2 PlantField3D::get_slope_limits() const {
	return properties.stand.slope_limits;
}

void PlantField3D::set_species(const TypedArray<PlantFieldSpecies> &entries) {
	listed = entries.duplicate();
	follow_species();
	mark_stale(true);
	update_configuration_warnings();
}

void PlantField3D::follow_species() {
	const Callable listener(this, "_on_species_changed");
	for (const uint64_t old : seen_species) {
		unfollow_changes(Object::cast_to<Resource>(ObjectDB::get_instance(old)), listener);
	}
	seen_species.clear();
	for (int64_t i = 0; i < listed.size(); i++) {
		Resource *entry = Object::cast_to<Resource>(listed[i]);
		seen_species.push_back(entry ? uint64_t(entry->get_instance_id()) : 0);
		follow_changes(entry, listener);
	}
	properties.stand.species = listed.duplicate();
	if (listed.is_empty()) {
		Ref<GrassFunction> grass;
		grass.instantiate();
		properties.stand.species.push_back(PlantFieldSpecies::of(grass));
	}
}

// One of them tells; which one, and of what, is asked.
void PlantField3D::on_species_changed() {
	for (int64_t i = 0; i < properties.stand.species.size(); i++) {
		const Ref<PlantFieldSpecies> entry = properties.stand.species[i];
		if (entry.is_null()) {
			return; // The library was reloaded, and the engine has not set it again yet.
		}
		if (entry->is_motion_change()) {
			meadow.read_motion(entry->get_species().ptr(), !may_simulate());
			return;
		}
		if (entry->is_species_change() && entry->get_species()->is_material_change()) {
			meadow.change_materials();
			return;
		}
		if (entry->is_species_change()) {
			mark_stale(false);
			return;
		}
	}
	mark_stale(true);
}

bool PlantField3D::lists(const Ref<PlantFunction> &function) const {
	for (int64_t i = 0; i < properties.stand.species.size(); i++) {
		const Ref<PlantFieldSpecies> entry = properties.stand.species[i];
		if (entry.is_valid() && entry->get_species() == function) {
			return true;
		}
	}
	return false;
}

// Of a species whose plants code added. What is on the list as well is heard of there.
void PlantField3D::on_added_species_changed() {
	for (const FieldLook &look : meadow.style.looks) {
		const bool is_motion = look.function.is_valid() && look.function->is_motion_change();
		if (!is_motion && (look.function.is_null() || !look.function->is_material_change())) {
			continue;
		}
		if (is_motion && !lists(look.function)) {
			meadow.read_motion(look.function.ptr(), !may_simulate());
		} else if (!lists(look.function)) {
			meadow.change_materials();
		}
		return;
	}
	mark_stale(false);
}

void PlantField3D::set_levels(const TypedArray<PlantFieldLevel> &entries) {
	const Callable listener(this, "_on_levels_changed");
	for (int64_t i = 0; i < seen_levels.size(); i++) {
		unfollow_changes(Object::cast_to<Resource>(seen_levels[i]), listener);
	}
	properties.view.levels = entries.duplicate();
	seen_levels = entries.duplicate();
	for (int64_t i = 0; i < properties.view.levels.size(); i++) {
		follow_changes(Object::cast_to<Resource>(properties.view.levels[i]), listener);
	}
	on_levels_changed();
}

void PlantField3D::on_levels_changed() {
	changed(About::view);
}

void PlantField3D::on_area_changed() {
	mark_stale(true);
	update_gizmos();
}

void PlantField3D::on_wind_changed() {
	update_configuration_warnings();
}

} // namespace undergrowth

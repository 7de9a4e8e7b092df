// PlantField3D's life in the tree. What users set: plant_field_3d_*_properties.cpp.

#include "field/plant_field_3d.hpp"

#include "follow_changes.hpp"

#include <godot_cpp/classes/world3d.hpp>

#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr double USUAL_STEP = 1.0 / 60.0; // s.

PlantField3D::PlantField3D() : clock(USUAL_STEP) {
	levels = { 12, 6, 3, 2 };
	level_distances = { 12.0f, 25.0f, 50.0f };
}

PlantField3D::~PlantField3D() {
	finish_step();
	fill_job.reset();
}

PackedStringArray PlantField3D::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (species.is_empty()) {
		warnings.push_back("This field needs a species: add a PlantFunction, such as a GrassFunction, to Species.");
	} else if (!problem.is_empty()) {
		warnings.push_back(problem);
	}
	if (levels.size() > level_distances.size() + 1) {
		warnings.push_back("Only " + String::num_int64(level_distances.size() + 1) + " of " +
				String::num_int64(levels.size()) +
				" Levels are drawn: give Level Distances a number for each level but the last.");
	}
	if (options.prototypes > 0 && options.contact) {
		warnings.push_back(
				"Plants that follow Prototypes do not touch each other: set Prototypes to 0, or Contact off.");
	}
	if (wind.is_valid() && wind->get_strength() == 0.0) {
		warnings.push_back(
				"The wind has a strength of 0 N, so these plants stand still: raise Strength in their Wind.");
	}
	return warnings;
}

// The inspector shows what counts for this ground and area. (Properties with a slider stay: a new list would end the
// dragging of it.)
void PlantField3D::_validate_property(PropertyInfo &property) const {
	const String name = property.name;
	const bool is_flat = options.ground == GROUND_NONE;
	const bool is_idle = (name == "size" && area.is_valid()) ||
			(name == "ground_mask" && options.ground != GROUND_COLLIDERS) ||
			(name == "ground_mesh" && options.ground != GROUND_MESH) ||
			(is_flat && (name == "height_limits" || name.begins_with("slope_")));
	if (is_idle) {
		property.usage &= ~uint32_t(PROPERTY_USAGE_EDITOR);
	}
}

void PlantField3D::on_species_changed() {
	for (int64_t i = 0; i < species.size(); i++) {
		const Ref<PlantFunction> function = species[i];
		if (function.is_null()) {
			return; // The library was reloaded, and the engine has not set it again yet.
		}
		if (!function->is_motion_change()) {
			continue;
		}
		// Only how it moves: its plants stay, and so does their motion.
		finish_step();
		for (size_t look = 0; look < style.looks.size(); look++) {
			if (style.looks[look].function == function && simulation) {
				style.looks[look].read_motion();
				simulation->set_species(int(look), style.looks[look].motion);
			}
		}
		return;
	}
	mark_stale();
}

void PlantField3D::on_area_changed() {
	mark_stale();
}

void PlantField3D::on_wind_changed() {
	update_configuration_warnings();
}

// From the field's axes to the world's. A field that is scaled to nothing, or is nowhere, counts as one at the origin,
// so that everything can be brought back into its axes.
Transform3D PlantField3D::axes() const {
	const Transform3D placed = get_global_transform();
	const float volume = placed.basis.determinant();
	return placed.is_finite() && std::isfinite(volume) && volume != 0.0f ? placed : Transform3D();
}

void PlantField3D::_notification(int what) {
	switch (what) {
		case NOTIFICATION_ENTER_TREE:
			set_notify_transform(true);
			skeletons.remove_strays(this);
			count_in_monitors(true);
			for (const std::unique_ptr<FieldDrawing> &drawing : drawings) {
				restart_drawing(*drawing);
			}
			if (is_stale && !fill_job && !species.is_empty()) {
				mark_stale();
			}
			update_processing();
			break;
		case NOTIFICATION_EXIT_TREE:
			finish_step();
			count_in_monitors(false);
			bodies.forget();
			for (const std::unique_ptr<FieldDrawing> &drawing : drawings) {
				drawing->set_scenario(RID());
			}
			break;
		case NOTIFICATION_EXTENSION_RELOADED:
			skeletons.remove_strays(this);
			mark_stale();
			break;
		case NOTIFICATION_INTERNAL_PROCESS:
			process_frame();
			break;
		case NOTIFICATION_INTERNAL_PHYSICS_PROCESS:
			cast_rays();
			break;
		case NOTIFICATION_TRANSFORM_CHANGED:
			for (const std::unique_ptr<FieldDrawing> &drawing : drawings) {
				drawing->set_transform(get_global_transform());
			}
			break;
		case NOTIFICATION_VISIBILITY_CHANGED:
			for (const std::unique_ptr<FieldDrawing> &drawing : drawings) {
				drawing->set_visible(is_visible_in_tree());
			}
			if (simulation) {
				finish_step();
				upload();
			}
			break;
		default:
			break;
	}
}

} // namespace undergrowth

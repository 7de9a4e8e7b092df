// PlantClimber3D: properties and bindings.

#include "nodes/plant_climber_3d.hpp"

#include "base/bind_properties.hpp"
#include "base/follow_changes.hpp"
#include "base/shortest_decimal.hpp"

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

namespace undergrowth {

template <class Number>
void PlantClimber3D::set_number(Number &slot, const char *property, double value, const Range &range) {
	if (value != double(slot) && accept_value(this, property, value, range)) {
		slot = Number(value);
		mark_dirty();
	}
}

void PlantClimber3D::set_species(const Ref<PlantFunction> &leaf) {
	if (leaf != species) {
		const Callable changed(this, "_on_species_changed");
		unfollow_changes(species.ptr(), changed);
		species = leaf;
		follow_changes(species.ptr(), changed);
		mark_dirty();
	}
}

void PlantClimber3D::on_species_changed() {
	if (species.is_valid() && species->is_motion_change()) {
		update_motion();
	} else {
		mark_dirty();
	}
}

void PlantClimber3D::set_wind(const Ref<PlantWind> &new_wind) {
	if (new_wind != wind) {
		const Callable changed(this, "_on_wind_changed");
		unfollow_changes(wind.ptr(), changed);
		wind = new_wind;
		follow_changes(wind.ptr(), changed);
		update_motion();
		update_configuration_warnings();
	}
}

void PlantClimber3D::on_wind_changed() {
	if (PlantWind::is_air(wind) != wind_is_air) {
		update_motion();
	}
	update_configuration_warnings();
}

void PlantClimber3D::set_supports(const TypedArray<NodePath> &paths) {
	supports = paths;
	mark_dirty();
	update_configuration_warnings();
}

void PlantClimber3D::set_path(const PackedVector3Array &points) {
	for (const Vector3 &point : points) {
		if (!point.is_finite()) {
			report_error(this, "path needs finite points; the last path stays.");
			return;
		}
	}
	path = points;
	mark_dirty();
}

void PlantClimber3D::set_seed(int64_t new_seed) {
	if (new_seed != seed) {
		seed = new_seed;
		mark_dirty();
	}
}

void PlantClimber3D::set_light_direction(const Vector3 &direction) {
	if (!direction.is_finite()) {
		report_error(this, "light_direction needs finite numbers; the last one stays.");
	} else if (direction != light_direction) {
		light_direction = direction;
		mark_dirty();
	}
}

void PlantClimber3D::set_shoots(int count) {
	set_number(settings.shoots, "shoots", count, { 1.0, 64.0 });
}

void PlantClimber3D::set_leaf_size(double scale) {
	set_number(leaf_size, "leaf_size", scale, { 0.05, 20.0 });
}

#define NUMBER(m_name, m_min, m_max)                                                                                   \
	void PlantClimber3D::set_##m_name(double value) {                                                                  \
		set_number(settings.m_name, #m_name, value, { m_min, m_max });                                                 \
	}                                                                                                                  \
	double PlantClimber3D::get_##m_name() const {                                                                      \
		return shortest_decimal(settings.m_name);                                                                      \
	}

NUMBER(length, 0.05, 200.0)
NUMBER(branching, 0.0, 20.0)
NUMBER(branch_length, 0.0, 1.0)
NUMBER(stem_spacing, 0.02, 5.0)
NUMBER(stem_diameter, 0.001, 0.5)
NUMBER(leaf_spacing, 0.005, 5.0)
NUMBER(light_weight, 0.0, 10.0)
NUMBER(gravity_weight, 0.0, 10.0)
NUMBER(random_weight, 0.0, 10.0)
NUMBER(adhesion_distance, 0.01, 5.0)
NUMBER(max_hanging, 0.0, 20.0)

void PlantClimber3D::set_simulation_enabled(bool enabled) {
	simulation_enabled = enabled;
	update_simulation();
}

void PlantClimber3D::set_stem_material(const Ref<Material> &material) {
	stem_material = material;
	view.set_stem_material(material);
}

void PlantClimber3D::set_layers(int64_t mask) {
	layers = mask;
	view.set_layers(uint32_t(mask));
}

void PlantClimber3D::set_cast_shadows(bool on) {
	cast_shadows = on;
	view.set_casts_shadows(on);
}

PackedStringArray PlantClimber3D::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (!problem.is_empty()) {
		warnings.push_back("The plant " + problem);
	}
	if (wind.is_valid() && wind->get_kind() != PlantWind::KIND_AIR && wind->get_strength() == 0.0) {
		warnings.push_back("The wind has a strength of 0 N, so no leaf moves: increase Strength of its Wind.");
	}
	return warnings;
}

void PlantClimber3D::bind_growth() {
	PROPERTY(INT, seed);
	BIND_PROPERTY(PACKED_VECTOR3_ARRAY, path, "get_path_points", &self_type::set_path, &self_type::get_path_points);
	PROPERTY(INT, shoots, SLIDER("1,64,1"));
	PROPERTY(FLOAT, length, SLIDER("0.05,50,0.05,or_greater,suffix:m"));
	PROPERTY(FLOAT, branching, SLIDER("0,20,0.1,suffix:1/m"));
	PROPERTY(FLOAT, branch_length, SLIDER("0,1,0.01"));
	PROPERTY(FLOAT, stem_spacing, SLIDER("0.02,5,0.01,suffix:m"));
	PROPERTY(FLOAT, stem_diameter, SLIDER("0.001,0.5,0.001,suffix:m"));
	PROPERTY(FLOAT, leaf_spacing, SLIDER("0.005,5,0.005,suffix:m"));
	PROPERTY(FLOAT, leaf_size, SLIDER("0.05,20,0.05"));
	PROPERTY(VECTOR3, light_direction);
	PROPERTY(FLOAT, light_weight, SLIDER("0,10,0.05"));
	PROPERTY(FLOAT, gravity_weight, SLIDER("0,10,0.05"));
	PROPERTY(FLOAT, random_weight, SLIDER("0,10,0.05"));
	PROPERTY(FLOAT, adhesion_distance, SLIDER("0.01,5,0.01,suffix:m"));
	PROPERTY(FLOAT, max_hanging, SLIDER("0,20,0.05,suffix:m"));
}

void PlantClimber3D::bind_queries() {
	BIND(rebuild);
	BIND(is_growing);
	BIND(get_leaf_count);
	BIND(get_stem_length);
	BIND(get_leaf_transform, "leaf");
	BIND(get_leaf_deflection, "leaf");
	BIND(get_reach);
	BIND(get_statistics);
	BIND(reset_motion);
	ClassDB::bind_method(D_METHOD("_preview", "delta", "wind"), &PlantClimber3D::preview);
	ClassDB::bind_method(D_METHOD("_pick", "from", "direction", "is_first"), &PlantClimber3D::pick);
	ClassDB::bind_method(D_METHOD("_on_rebuild_queued"), &PlantClimber3D::on_rebuild_queued);
	ClassDB::bind_method(D_METHOD("_on_species_changed"), &PlantClimber3D::on_species_changed);
	ClassDB::bind_method(D_METHOD("_on_wind_changed"), &PlantClimber3D::on_wind_changed);
	ADD_SIGNAL(MethodInfo("grown"));
}

void PlantClimber3D::_bind_methods() {
	PROPERTY(OBJECT, species, PROPERTY_HINT_RESOURCE_TYPE, "PlantFunction");
	PROPERTY(OBJECT, wind, PROPERTY_HINT_RESOURCE_TYPE, "PlantWind");
	PROPERTY(ARRAY, supports, PROPERTY_HINT_ARRAY_TYPE, "NodePath");
	ADD_GROUP("Growth", "");
	bind_growth();
	ADD_GROUP("View", "");
	BIND_PROPERTY(BOOL, simulation_enabled, "is_simulation_enabled", &self_type::set_simulation_enabled,
			&self_type::is_simulation_enabled);
	PROPERTY(OBJECT, stem_material, PROPERTY_HINT_RESOURCE_TYPE, "Material");
	PROPERTY(INT, layers, PROPERTY_HINT_LAYERS_3D_RENDER);
	BIND_PROPERTY(BOOL, cast_shadows, "is_cast_shadows", &self_type::set_cast_shadows, &self_type::is_cast_shadows);
	bind_queries();
}

} // namespace undergrowth

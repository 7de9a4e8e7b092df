#include "field/resources/plant_field_species.hpp"

#include "base/auto_name.hpp"
#include "base/bind_properties.hpp"
#include "base/follow_changes.hpp"
#include "base/new_object.hpp"
#include "base/renamed_properties.hpp"
#include "base/shortest_decimal.hpp"
#include "placement/competition.hpp"

#include <utility>

using namespace godot;

namespace undergrowth {

Ref<PlantFieldSpecies> PlantFieldSpecies::of(const Ref<PlantFunction> &function, double weight) {
	Ref<PlantFieldSpecies> made = new_counted<PlantFieldSpecies>();
	made->set_species(function);
	made->set_weight(weight);
	return made;
}

void PlantFieldSpecies::report_change(ChangeKind kind, bool from_species) {
	// A listener may set a property, which emits again inside this emission.
	const ChangeKind kind_before = std::exchange(change_kind, kind);
	const bool before = std::exchange(forwards, from_species);
	emit_changed();
	change_kind = kind_before;
	forwards = before;
}

void PlantFieldSpecies::on_species_changed() {
	const Ref<PlantFieldSpecies> alive(this); // Listeners may release the last reference.
	update_auto_name(this, auto_name, name_of_species(species));
	if (species.is_null()) { // The library was reloaded, and the engine has not restored the function yet.
		report_change(CHANGE_PLACEMENT, false);
	} else {
		report_change(species->is_motion_change() ? CHANGE_MOTION : CHANGE_APPEARANCE, true);
	}
}

template <class Value> void PlantFieldSpecies::set(Value &slot, const Value &value, ChangeKind kind) {
	if (value != slot) {
		slot = value;
		report_change(kind, false);
	}
}

template <class Value>
void PlantFieldSpecies::set_number(Value &slot, const char *name, Value value, const Range &range, ChangeKind kind) {
	if (accept_value(this, name, double(value), range)) {
		set(slot, value, kind);
	}
}

void PlantFieldSpecies::set_species(const Ref<PlantFunction> &function) {
	if (function == species) {
		return;
	}
	const Callable changed(this, "_on_species_changed");
	unfollow_changes(species.ptr(), changed);
	species = function;
	follow_changes(species.ptr(), changed);
	update_auto_name(this, auto_name, name_of_species(species));
	report_change(CHANGE_PLACEMENT, false);
}

void PlantFieldSpecies::on_habitat_changed() {
	const Ref<PlantFieldSpecies> alive(this);
	report_change(CHANGE_PLACEMENT, false);
}

void PlantFieldSpecies::set_habitat(const Ref<PlantHabitat> &where) {
	if (where == habitat) {
		return;
	}
	const Callable changed(this, "_on_habitat_changed");
	unfollow_changes(habitat.ptr(), changed);
	habitat = where;
	follow_changes(habitat.ptr(), changed);
	report_change(CHANGE_PLACEMENT, false);
}

void PlantFieldSpecies::set_weight(double value) {
	set_number(weight, "weight", value, { 0.0, 1e6 });
}

void PlantFieldSpecies::set_density_factor(double factor) {
	set_number(density_factor, "density_factor", factor, { 0.0, 1000.0 });
}

void PlantFieldSpecies::set_scale_range(const Vector2 &range) {
	Vector2 ordered = range;
	if (accept_span(this, "scale_range", scale_range, ordered, { 0.001, 1000.0 })) {
		set(scale_range, ordered, CHANGE_PLACEMENT);
	}
}

void PlantFieldSpecies::set_height_deviation(double deviation) {
	set_number(height_deviation, "height_deviation", deviation, { 0.0, 0.9 });
}

void PlantFieldSpecies::set_lean_deviation(double radians) {
	if (accept_angle(this, "lean_deviation", radians, { 0.0, 80.0 })) {
		set(lean_deviation, exact_angle(radians), CHANGE_PLACEMENT);
	}
}

void PlantFieldSpecies::set_vigor(double factor) {
	set_number(vigor, "vigor", factor, { 0.001, 1000.0 });
}

void PlantFieldSpecies::set_shade_radius(double metres) {
	set_number(shade_radius, "shade_radius", metres, { 0.0, double(Competition::MAX_RADIUS) });
}

void PlantFieldSpecies::set_shade_tolerance(double chance) {
	set_number(shade_tolerance, "shade_tolerance", chance, { 0.0, 1.0 });
}

void PlantFieldSpecies::set_variants(int count) {
	set_number(variants, "variants", count, { 1, 64 });
}

void PlantFieldSpecies::set_lod_bias(double factor) {
	set_number(lod_bias, "lod_bias", factor, { 0.1, 10.0 }, CHANGE_APPEARANCE);
}

void PlantFieldSpecies::set_layer(const String &name) {
	set(layer, name, CHANGE_PLACEMENT);
}

String PlantFieldSpecies::get_layer_name() const {
	return layer.is_empty() ? name_of_species(species) : layer;
}

void PlantFieldSpecies::_validate_property(PropertyInfo &property) const {
	hide_auto_name(this, auto_name, property);
}

bool PlantFieldSpecies::_set(const StringName &name, const Variant &value) {
	return set_renamed_property(this, name, value, { { "share", "weight" }, { "detail", "lod_bias" } });
}

void PlantFieldSpecies::_bind_methods() {
	ClassDB::bind_static_method(
			"PlantFieldSpecies", D_METHOD("of", "species", "weight"), &PlantFieldSpecies::of, DEFVAL(1.0));
	ClassDB::bind_method(D_METHOD("_on_species_changed"), &PlantFieldSpecies::on_species_changed);
	ClassDB::bind_method(D_METHOD("_on_habitat_changed"), &PlantFieldSpecies::on_habitat_changed);
	BIND(get_change_kind);
	BIND(get_layer_name);
	PROPERTY(OBJECT, species, PROPERTY_HINT_RESOURCE_TYPE, "PlantFunction");
	PROPERTY(FLOAT, weight, SLIDER("0,10,0.01,or_greater"));
	PROPERTY(FLOAT, density_factor, SLIDER("0,4,0.01,or_greater"));
	PROPERTY(VECTOR2, scale_range, SLIDER("0.1,4,0.01,or_less,or_greater"));
	PROPERTY(FLOAT, height_deviation, SLIDER("0,0.9,0.01"));
	PROPERTY(FLOAT, lean_deviation, SLIDER("0,80,0.1,radians_as_degrees"));
	PROPERTY(INT, variants, SLIDER("1,64,1"));
	PROPERTY(FLOAT, lod_bias, SLIDER("0.25,4,0.05,or_less,or_greater"));
	PROPERTY(OBJECT, habitat, PROPERTY_HINT_RESOURCE_TYPE, "PlantHabitat");
	PROPERTY(FLOAT, vigor, SLIDER("0.1,10,0.01,or_less,or_greater"));
	PROPERTY(FLOAT, shade_radius, SLIDER("0,2,0.01,or_greater,suffix:m"));
	PROPERTY(FLOAT, shade_tolerance, SLIDER("0,1,0.01"));
	PROPERTY(STRING, layer);
	BIND_ENUM_CONSTANT(CHANGE_NONE);
	BIND_ENUM_CONSTANT(CHANGE_PLACEMENT);
	BIND_ENUM_CONSTANT(CHANGE_APPEARANCE);
	BIND_ENUM_CONSTANT(CHANGE_MOTION);
}

} // namespace undergrowth

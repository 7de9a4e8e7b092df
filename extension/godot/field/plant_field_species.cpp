#include "field/plant_field_species.hpp"

#include "as_written.hpp"
#include "follow_changes.hpp"
#include "given_name.hpp"
#include "new_object.hpp"

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

namespace undergrowth {

static constexpr Range SHARE_RANGE = { 0.0, 1e6 };
static constexpr Range DENSITY_FACTOR_RANGE = { 0.0, 1000.0 };
static constexpr Range SCALE_RANGE = { 0.001, 1000.0 };
static constexpr Range HEIGHT_DEVIATION_RANGE = { 0.0, 0.9 };
static constexpr Range LEAN_DEVIATION_DEGREES = { 0.0, 80.0 };
static constexpr Range VARIANTS_RANGE = { 1, 64 };

Ref<PlantFieldSpecies> PlantFieldSpecies::of(const Ref<PlantFunction> &function, double share) {
	Ref<PlantFieldSpecies> made = new_counted<PlantFieldSpecies>();
	made->set_species(function);
	made->set_share(share);
	return made;
}

void PlantFieldSpecies::tell(bool from_species) {
	const bool before = forwards; // A listener may set something: an emission within an emission.
	forwards = from_species;
	emit_changed();
	forwards = before;
}

bool PlantFieldSpecies::is_species_change() const {
	return forwards;
}

bool PlantFieldSpecies::is_motion_change() const {
	return forwards && species.is_valid() && species->is_motion_change();
}

void PlantFieldSpecies::on_species_changed() {
	const Ref<PlantFieldSpecies> alive(this); // Listeners may drop it.
	give_name(this, given_name, name_of_species(species));
	tell(true);
}

void PlantFieldSpecies::set_number(double &slot, double value) {
	if (value != slot) {
		slot = value;
		tell(false);
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
	give_name(this, given_name, name_of_species(species));
	tell(false);
}

Ref<PlantFunction> PlantFieldSpecies::get_species() const {
	return species;
}

void PlantFieldSpecies::set_share(double weight) {
	if (accept_value(this, "share", weight, SHARE_RANGE)) {
		set_number(share, weight);
	}
}

double PlantFieldSpecies::get_share() const {
	return share;
}

void PlantFieldSpecies::set_density_factor(double factor) {
	if (accept_value(this, "density_factor", factor, DENSITY_FACTOR_RANGE)) {
		set_number(density_factor, factor);
	}
}

double PlantFieldSpecies::get_density_factor() const {
	return density_factor;
}

void PlantFieldSpecies::set_scale_range(const Vector2 &range) {
	if (accept_span(this, "scale_range", range, SCALE_RANGE) && range != scale_range) {
		scale_range = range;
		tell(false);
	}
}

Vector2 PlantFieldSpecies::get_scale_range() const {
	return scale_range;
}

void PlantFieldSpecies::set_height_deviation(double deviation) {
	if (accept_value(this, "height_deviation", deviation, HEIGHT_DEVIATION_RANGE)) {
		set_number(height_deviation, deviation);
	}
}

double PlantFieldSpecies::get_height_deviation() const {
	return height_deviation;
}

void PlantFieldSpecies::set_lean_deviation(double radians) {
	if (accept_angle(this, "lean_deviation", radians, LEAN_DEVIATION_DEGREES)) {
		set_number(lean_deviation, angle_as_written(radians));
	}
}

double PlantFieldSpecies::get_lean_deviation() const {
	return lean_deviation;
}

void PlantFieldSpecies::set_variants(int count) {
	if (accept_value(this, "variants", count, VARIANTS_RANGE) && count != variants) {
		variants = count;
		tell(false);
	}
}

int PlantFieldSpecies::get_variants() const {
	return variants;
}

void PlantFieldSpecies::_validate_property(PropertyInfo &property) const {
	hide_given_name(this, given_name, property);
}

static PropertyInfo number(const char *name, const char *range) {
	return PropertyInfo(Variant::FLOAT, name, PROPERTY_HINT_RANGE, range);
}

void PlantFieldSpecies::_bind_methods() {
	ClassDB::bind_static_method(
			"PlantFieldSpecies", D_METHOD("of", "species", "share"), &PlantFieldSpecies::of, DEFVAL(1.0));
	ClassDB::bind_method(D_METHOD("_on_species_changed"), &PlantFieldSpecies::on_species_changed);
	ClassDB::bind_method(D_METHOD("is_species_change"), &PlantFieldSpecies::is_species_change);
	ClassDB::bind_method(D_METHOD("is_motion_change"), &PlantFieldSpecies::is_motion_change);
	ClassDB::bind_method(D_METHOD("set_species", "species"), &PlantFieldSpecies::set_species);
	ClassDB::bind_method(D_METHOD("get_species"), &PlantFieldSpecies::get_species);
	ClassDB::bind_method(D_METHOD("set_share", "share"), &PlantFieldSpecies::set_share);
	ClassDB::bind_method(D_METHOD("get_share"), &PlantFieldSpecies::get_share);
	ClassDB::bind_method(D_METHOD("set_density_factor", "factor"), &PlantFieldSpecies::set_density_factor);
	ClassDB::bind_method(D_METHOD("get_density_factor"), &PlantFieldSpecies::get_density_factor);
	ClassDB::bind_method(D_METHOD("set_scale_range", "range"), &PlantFieldSpecies::set_scale_range);
	ClassDB::bind_method(D_METHOD("get_scale_range"), &PlantFieldSpecies::get_scale_range);
	ClassDB::bind_method(D_METHOD("set_height_deviation", "deviation"), &PlantFieldSpecies::set_height_deviation);
	ClassDB::bind_method(D_METHOD("get_height_deviation"), &PlantFieldSpecies::get_height_deviation);
	ClassDB::bind_method(D_METHOD("set_lean_deviation", "radians"), &PlantFieldSpecies::set_lean_deviation);
	ClassDB::bind_method(D_METHOD("get_lean_deviation"), &PlantFieldSpecies::get_lean_deviation);
	ClassDB::bind_method(D_METHOD("set_variants", "count"), &PlantFieldSpecies::set_variants);
	ClassDB::bind_method(D_METHOD("get_variants"), &PlantFieldSpecies::get_variants);

	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "species", PROPERTY_HINT_RESOURCE_TYPE, "PlantFunction"), "set_species",
			"get_species");
	ADD_PROPERTY(number("share", "0,10,0.01,or_greater"), "set_share", "get_share");
	ADD_PROPERTY(number("density_factor", "0,4,0.01,or_greater"), "set_density_factor", "get_density_factor");
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR2, "scale_range", PROPERTY_HINT_RANGE, "0.1,4,0.01,or_less,or_greater"),
			"set_scale_range", "get_scale_range");
	ADD_PROPERTY(number("height_deviation", "0,0.9,0.01"), "set_height_deviation", "get_height_deviation");
	ADD_PROPERTY(number("lean_deviation", "0,80,0.1,radians_as_degrees"), "set_lean_deviation", "get_lean_deviation");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "variants", PROPERTY_HINT_RANGE, "1,64,1"), "set_variants", "get_variants");
}

} // namespace undergrowth

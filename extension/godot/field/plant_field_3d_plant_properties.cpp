// What users set of a PlantField3D: which plants, how many and how they differ; and how values are accepted.

#include "field/plant_field_3d.hpp"

#include "follow_changes.hpp"

using namespace godot;

namespace undergrowth {

static constexpr Range DENSITY_RANGE = { 0.0, 10000.0 };
static constexpr Range CLUMPING_RANGE = { 0.0, 1.0 };
static constexpr Range DRIFT_SIZE_RANGE = { 0.01, 1000.0 };
static constexpr Range HEIGHT_DEVIATION_RANGE = { 0.0, 0.9 };
static constexpr Range LEAN_DEVIATION_DEGREES_RANGE = { 0.0, 80.0 };
static constexpr Range VARIANTS_RANGE = { 1, 64 };
static constexpr Range SCALE_RANGE = { 0.001, 1000.0 };

void PlantField3D::set_number(double &slot, const char *name, double value, const Range &range, bool needs_fill) {
	if (accept_value(this, name, value, range) && value != slot) {
		slot = value;
		if (needs_fill) {
			mark_stale();
		}
	}
}

void PlantField3D::set_whole(int &slot, const char *name, int value, const Range &range, bool needs_fill) {
	if (accept_value(this, name, value, range) && value != slot) {
		slot = value;
		if (needs_fill) {
			mark_stale();
		}
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
		return;
	}
	slot = value;
	mark_stale();
}

void PlantField3D::set_species(const TypedArray<PlantFunction> &functions) {
	const Callable changed(this, "_on_species_changed");
	for (int64_t i = 0; i < species.size(); i++) {
		unfollow_changes(Object::cast_to<Resource>(species[i]), changed);
	}
	species = functions.duplicate();
	for (int64_t i = 0; i < species.size(); i++) {
		follow_changes(Object::cast_to<Resource>(species[i]), changed);
	}
	mark_stale();
	update_configuration_warnings();
}

TypedArray<PlantFunction> PlantField3D::get_species() const {
	return species;
}

void PlantField3D::set_shares(const PackedFloat32Array &weights) {
	shares = weights;
	mark_stale();
}

PackedFloat32Array PlantField3D::get_shares() const {
	return shares;
}

void PlantField3D::set_density(double value) {
	set_number(options.density, "density", value, DENSITY_RANGE, true);
}

double PlantField3D::get_density() const {
	return options.density;
}

void PlantField3D::set_seed(int64_t seed) {
	options.seed = seed;
	mark_stale();
}

int64_t PlantField3D::get_seed() const {
	return options.seed;
}

void PlantField3D::set_clumping(double value) {
	set_number(options.clumping, "clumping", value, CLUMPING_RANGE, true);
}

double PlantField3D::get_clumping() const {
	return options.clumping;
}

void PlantField3D::set_drift_size(double value) {
	set_number(options.drift_size, "drift_size", value, DRIFT_SIZE_RANGE, true);
}

double PlantField3D::get_drift_size() const {
	return options.drift_size;
}

void PlantField3D::set_variants(int value) {
	set_whole(options.variants, "variants", value, VARIANTS_RANGE, true);
}

int PlantField3D::get_variants() const {
	return options.variants;
}

void PlantField3D::set_scale_range(const Vector2 &range) {
	set_span(options.scale_range, "scale_range", range, SCALE_RANGE);
}

Vector2 PlantField3D::get_scale_range() const {
	return options.scale_range;
}

void PlantField3D::set_height_deviation(double value) {
	set_number(options.height_deviation, "height_deviation", value, HEIGHT_DEVIATION_RANGE, true);
}

double PlantField3D::get_height_deviation() const {
	return options.height_deviation;
}

void PlantField3D::set_lean_deviation_degrees(double value) {
	set_number(options.lean_deviation_degrees, "lean_deviation_degrees", value, LEAN_DEVIATION_DEGREES_RANGE, true);
}

double PlantField3D::get_lean_deviation_degrees() const {
	return options.lean_deviation_degrees;
}

} // namespace undergrowth

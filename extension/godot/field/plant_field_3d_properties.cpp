// What users set of a PlantField3D.

#include "field/plant_field_3d.hpp"

#include "follow_changes.hpp"
#include "plant/base_shape.hpp"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr Range DENSITY_RANGE = { 0.0, 10000.0 };
static constexpr Range CLUMPING_RANGE = { 0.0, 1.0 };
static constexpr Range DRIFT_SIZE_RANGE = { 0.01, 1000.0 };
static constexpr Range HEIGHT_DEVIATION_RANGE = { 0.0, 0.9 };
static constexpr Range LEAN_DEVIATION_DEGREES_RANGE = { 0.0, 80.0 };
static constexpr Range WIND_SPEED_RANGE = { 0.0, 10000.0 };
static constexpr Range FAR_DISTANCE_RANGE = { 0.0, 1e6 };
static constexpr Range TOUCH_MARGIN_RANGE = { 0.0, 100.0 };
static constexpr Range FADE_MARGIN_RANGE = { 0.0, 1000.0 };
static constexpr Range SHADOW_DISTANCE_RANGE = { 0.0, 1e6 };
static constexpr Range VISIBILITY_RANGE_RANGE = { 0.0, 1e6 };
static constexpr Range CHUNK_SIZE_RANGE = { 1.0, 1000.0 };
static constexpr Range VARIANTS_RANGE = { 1, 64 };
static constexpr Range THREADS_RANGE = { 0, 256 };
static constexpr Range PROTOTYPES_RANGE = { 0, 64 };
static constexpr Range SIZE_RANGE = { 0.0, 1e5 };
static constexpr Range SCALE_RANGE = { 0.001, 1000.0 };
static constexpr Range HEIGHT_LIMITS_RANGE = { -1e6, 1e6 };
static constexpr Range SLOPE_LIMITS_RANGE = { 0.0, 180.0 };
static constexpr Range INTERVAL_RANGE = { 1, 64 };
static constexpr Range LOD_RANGE = { MIN_LOD, MAX_LOD };

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

void PlantField3D::set_density(double value) {
	set_number(options.density, "density", value, DENSITY_RANGE, true);
}

double PlantField3D::get_density() const {
	return options.density;
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

void PlantField3D::set_wind_speed(double value) {
	set_number(options.wind_speed, "wind_speed", value, WIND_SPEED_RANGE, false);
}

double PlantField3D::get_wind_speed() const {
	return options.wind_speed;
}

void PlantField3D::set_far_distance(double value) {
	set_number(options.far_distance, "far_distance", value, FAR_DISTANCE_RANGE, false);
}

double PlantField3D::get_far_distance() const {
	return options.far_distance;
}

void PlantField3D::set_touch_margin(double value) {
	set_number(options.touch_margin, "touch_margin", value, TOUCH_MARGIN_RANGE, false);
}

double PlantField3D::get_touch_margin() const {
	return options.touch_margin;
}

void PlantField3D::set_fade_margin(double value) {
	set_number(options.fade_margin, "fade_margin", value, FADE_MARGIN_RANGE, true);
}

double PlantField3D::get_fade_margin() const {
	return options.fade_margin;
}

void PlantField3D::set_shadow_distance(double value) {
	set_number(options.shadow_distance, "shadow_distance", value, SHADOW_DISTANCE_RANGE, true);
}

double PlantField3D::get_shadow_distance() const {
	return options.shadow_distance;
}

void PlantField3D::set_visibility_range(double value) {
	set_number(options.visibility_range, "visibility_range", value, VISIBILITY_RANGE_RANGE, true);
}

double PlantField3D::get_visibility_range() const {
	return options.visibility_range;
}

void PlantField3D::set_chunk_size(double value) {
	set_number(options.chunk_size, "chunk_size", value, CHUNK_SIZE_RANGE, true);
}

double PlantField3D::get_chunk_size() const {
	return options.chunk_size;
}

void PlantField3D::set_variants(int value) {
	set_whole(options.variants, "variants", value, VARIANTS_RANGE, true);
}

int PlantField3D::get_variants() const {
	return options.variants;
}

void PlantField3D::set_threads(int value) {
	set_whole(options.threads, "threads", value, THREADS_RANGE, false);
}

int PlantField3D::get_threads() const {
	return options.threads;
}

void PlantField3D::set_prototypes(int value) {
	set_whole(options.prototypes, "prototypes", value, PROTOTYPES_RANGE, true);
}

int PlantField3D::get_prototypes() const {
	return options.prototypes;
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

void PlantField3D::set_size(const Vector2 &metres) {
	if (accept_value(this, "size", metres.x, SIZE_RANGE) && accept_value(this, "size", metres.y, SIZE_RANGE)) {
		options.size = metres;
		mark_stale();
	}
}

Vector2 PlantField3D::get_size() const {
	return options.size;
}

void PlantField3D::set_area(const Ref<Curve3D> &curve) {
	const Callable changed(this, "_on_area_changed");
	unfollow_changes(area.ptr(), changed);
	area = curve;
	follow_changes(area.ptr(), changed);
	mark_stale();
}

Ref<Curve3D> PlantField3D::get_area() const {
	return area;
}

void PlantField3D::set_exclusions(const TypedArray<Curve3D> &curves) {
	const Callable changed(this, "_on_area_changed");
	for (int64_t i = 0; i < exclusions.size(); i++) {
		unfollow_changes(Object::cast_to<Resource>(exclusions[i]), changed);
	}
	exclusions = curves.duplicate();
	for (int64_t i = 0; i < exclusions.size(); i++) {
		follow_changes(Object::cast_to<Resource>(exclusions[i]), changed);
	}
	mark_stale();
}

TypedArray<Curve3D> PlantField3D::get_exclusions() const {
	return exclusions;
}

void PlantField3D::set_excluded_fields(const TypedArray<NodePath> &paths) {
	excluded_fields = paths;
	mark_stale();
}

TypedArray<NodePath> PlantField3D::get_excluded_fields() const {
	return excluded_fields;
}

void PlantField3D::set_seed(int64_t seed) {
	options.seed = seed;
	mark_stale();
}

int64_t PlantField3D::get_seed() const {
	return options.seed;
}

void PlantField3D::set_scale_range(const Vector2 &range) {
	set_span(options.scale_range, "scale_range", range, SCALE_RANGE);
}

Vector2 PlantField3D::get_scale_range() const {
	return options.scale_range;
}

void PlantField3D::set_ground(GroundKind kind) {
	if (kind < GROUND_NONE || kind > GROUND_MESH) {
		report_error(
				this, "ground " + String::num_int64(int(kind)) + " does not exist. Use one of the GROUND_ constants.");
		return;
	}
	options.ground = int(kind);
	notify_property_list_changed();
	mark_stale();
}

PlantField3D::GroundKind PlantField3D::get_ground() const {
	return GroundKind(options.ground);
}

void PlantField3D::set_ground_mask(int64_t mask) {
	options.ground_mask = mask;
	mark_stale();
}

int64_t PlantField3D::get_ground_mask() const {
	return options.ground_mask;
}

void PlantField3D::set_ground_mesh(const NodePath &path) {
	ground_mesh = path;
	mark_stale();
}

NodePath PlantField3D::get_ground_mesh() const {
	return ground_mesh;
}

void PlantField3D::set_height_limits(const Vector2 &metres) {
	set_span(options.height_limits, "height_limits", metres, HEIGHT_LIMITS_RANGE);
}

Vector2 PlantField3D::get_height_limits() const {
	return options.height_limits;
}

void PlantField3D::set_slope_limits_degrees(const Vector2 &degrees) {
	set_span(options.slope_limits_degrees, "slope_limits_degrees", degrees, SLOPE_LIMITS_RANGE);
}

Vector2 PlantField3D::get_slope_limits_degrees() const {
	return options.slope_limits_degrees;
}

void PlantField3D::set_wind(const Ref<PlantWind> &new_wind) {
	wind = new_wind;
	seen_wind_time = -1.0;
}

Ref<PlantWind> PlantField3D::get_wind() const {
	return wind;
}

void PlantField3D::set_simulating(bool on) {
	options.simulating = on;
	update_processing();
}

bool PlantField3D::is_simulating() const {
	return options.simulating;
}

void PlantField3D::set_update_interval(int step_count) {
	set_whole(options.update_interval, "update_interval", step_count, INTERVAL_RANGE, false);
	if (simulation) {
		finish_step();
		simulation->set_update_interval(options.update_interval);
	}
}

int PlantField3D::get_update_interval() const {
	return options.update_interval;
}

void PlantField3D::set_contact(bool on) {
	options.contact = on;
	if (on && simulation) {
		finish_step();
		touching.fit(*simulation);
	}
}

bool PlantField3D::has_contact() const {
	return options.contact;
}

void PlantField3D::set_bodies_group(const StringName &group) {
	bodies_group = group;
}

StringName PlantField3D::get_bodies_group() const {
	return bodies_group;
}

void PlantField3D::set_levels(const PackedInt32Array &lods) {
	for (int64_t i = 0; i < lods.size(); i++) {
		if (!accept_value(this, "levels", lods[i], LOD_RANGE)) {
			return;
		}
	}
	if (lods.is_empty()) {
		report_error(this, "levels cannot be empty, it keeps its value. Set at least one number of segments.");
		return;
	}
	levels = lods;
	mark_stale();
}

PackedInt32Array PlantField3D::get_levels() const {
	return levels;
}

void PlantField3D::set_level_distances(const PackedFloat32Array &metres) {
	for (int64_t i = 0; i < metres.size(); i++) {
		if (!std::isfinite(metres[i]) || metres[i] <= (i > 0 ? metres[i - 1] : 0.0f)) {
			report_error(this, "level_distances must grow from above 0; they keep their values.");
			return;
		}
	}
	level_distances = metres;
	mark_stale();
}

PackedFloat32Array PlantField3D::get_level_distances() const {
	return level_distances;
}

void PlantField3D::set_layers(int64_t mask) {
	options.layers = mask;
	for (const std::unique_ptr<FieldDrawing> &drawing : drawings) {
		drawing->set_layers(uint32_t(mask));
	}
}

int64_t PlantField3D::get_layers() const {
	return options.layers;
}

} // namespace undergrowth

// What users set of a PlantField3D: how plants are drawn.

#include "field/plant_field_3d.hpp"

#include "plant/base_shape.hpp"

#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr Range FADE_MARGIN_RANGE = { 0.0, 1000.0 };
static constexpr Range SHADOW_DISTANCE_RANGE = { 0.0, 1e6 };
static constexpr Range VISIBILITY_RANGE_RANGE = { 0.0, 1e6 };
static constexpr Range CHUNK_SIZE_RANGE = { 1.0, 1000.0 };
static constexpr Range SKELETON_DISTANCE_RANGE = { 0.0, 1e6 };
static constexpr Range MOST_SKELETONS_RANGE = { 0, 1024 };
static constexpr Range LOD_RANGE = { MIN_LOD, MAX_LOD };

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
	update_configuration_warnings();
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
	update_configuration_warnings();
	mark_stale();
}

PackedFloat32Array PlantField3D::get_level_distances() const {
	return level_distances;
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

void PlantField3D::set_skeleton_distance(double value) {
	set_number(options.skeleton_distance, "skeleton_distance", value, SKELETON_DISTANCE_RANGE, false);
	skeletons_changed();
}

double PlantField3D::get_skeleton_distance() const {
	return options.skeleton_distance;
}

void PlantField3D::set_most_skeletons(int value) {
	set_whole(options.most_skeletons, "most_skeletons", value, MOST_SKELETONS_RANGE, false);
	skeletons_changed();
}

int PlantField3D::get_most_skeletons() const {
	return options.most_skeletons;
}

void PlantField3D::set_layers(int64_t mask) {
	options.layers = mask;
	for (const std::unique_ptr<FieldDrawing> &drawing : drawings) {
		drawing->set_layers(uint32_t(mask));
	}
	skeletons.set_layers(uint32_t(mask));
}

int64_t PlantField3D::get_layers() const {
	return options.layers;
}

} // namespace undergrowth

#include "field/view/field_levels.hpp"
#include "base/renderer.hpp"
#include "field/view/field_fitting.hpp"

#include <godot_cpp/classes/project_settings.hpp>

#include <algorithm>

using namespace godot;

namespace undergrowth {

static constexpr float MIN_MARGIN = 1e-3f; // m.
static constexpr float MIN_BIAS = 0.01f;
static constexpr double MIN_PIXEL_ERROR = 0.05;

SightRange sight_range_of(const GeometryInstance3D *node) {
	return { float(node->get_visibility_range_end()), std::max(float(node->get_lod_bias()), MIN_BIAS) };
}

String find_level_fault(const ViewOptions &options) {
	float before = 0.0f;
	for (int64_t i = 0; i < options.levels.size(); i++) {
		const Ref<PlantFieldLevel> level = options.levels[i];
		const String name = "levels[" + String::num_int64(i) + "]";
		if (level.is_null()) {
			return name + String(" is empty. Set a PlantFieldLevel, or remove the entry.");
		}
		const float end = float(level->get_end());
		const bool has_end = end > 0.0f || i + 1 < options.levels.size();
		if (has_end && end <= before) {
			return name + String(" ends at ") + String::num(end) +
					" m, which is not beyond the previous level. Set a larger end. Only the last level may end at 0, "
					"which means never.";
		}
		before = end;
	}
	return String();
}

struct ListedLevel {
	int segments;
	float end; // m; 0: never.
	float share;
};

// True if the field is built with plants of parts. Added plants do not count.
static bool has_parts(const PlacementOptions &options) {
	for (int64_t i = 0; i < options.species.size() && options.density > 0.0; i++) {
		const Ref<PlantFieldSpecies> entry = options.species[i];
		if (entry.is_valid() && entry->get_species().is_valid() && entry->get_species()->has_parts()) {
			return true;
		}
	}
	return false;
}

// Nominal distances: each species of parts has its own.
static std::vector<ListedLevel> ladder_by_error() {
	return { { 24, 1.0f, 1.0f }, { 14, 2.5f, 1.0f }, { 11, 4.0f, 1.0f }, { 8, 6.0f, 1.0f }, { 6, 10.0f, 1.0f },
		{ 5, 14.0f, 1.0f }, { 4, 22.0f, 1.0f }, { 3, 35.0f, 1.0f }, { 2, 0.0f, 1.0f } };
}

bool is_for_solids(int segments) {
	return segments == 11 || segments == 6 || segments == 4;
}

static std::vector<ListedLevel> list_levels(const FieldProperties &options) {
	std::vector<ListedLevel> listed;
	for (int64_t i = 0; i < options.levels.size(); i++) {
		const Ref<PlantFieldLevel> level = options.levels[i];
		if (level.is_valid()) {
			listed.push_back({ level->get_segments(), float(level->get_end()), float(level->get_density()) });
		}
	}
	if (!listed.empty()) {
		return listed;
	}
	if (has_parts(options)) {
		return ladder_by_error();
	}
	return { { 12, 12.0f, 1.0f }, { 6, 25.0f, 1.0f }, { 3, 50.0f, 1.0f }, { 2, 0.0f, 1.0f } };
}

// Of the number of variants at a level by error. A plant must not change its form where its stems can be counted.
static int halvings_by_error(int segments) {
	return segments >= 8 ? 0 : segments >= 5 ? 1 : segments >= 3 ? 2 : 3;
}

// A level without end reaches its density at twice the distance at which it begins.
static LodDensity density_between(const LodDensity *before, float begin, float end, float share) {
	LodDensity made;
	made.distances[1] = begin;
	made.distances[2] = end > begin ? end : 2.0f * begin;
	made.densities[2] = share;
	if (before) {
		made.distances[0] = before->distances[1];
		made.densities[0] = before->densities[1];
		made.densities[1] = before->densities[2];
	} else if (end <= 0.0f) {
		std::fill(made.densities, made.densities + 3, share);
	}
	return made;
}

// Density by distance of plants of parts. The same at all levels.
static const LodDensity USUAL_THINNING = { { 8.0f, 22.0f, 60.0f }, { 1.0f, 0.5f, 0.12f } };

static float pixel_error_of(const ViewOptions &options) {
	static constexpr double PIXELS_OF_THRESHOLD = 2.0;
	const double usual =
			ProjectSettings::get_singleton()->get_setting("rendering/mesh_lod/lod_change/threshold_pixels", 1.0);
	const double wanted = options.pixel_error > 0.0 ? options.pixel_error : PIXELS_OF_THRESHOLD * usual;
	return float(std::max(wanted, MIN_PIXEL_ERROR));
}

LevelRule read_level_rule(const FieldProperties &options, const SightRange &range) {
	LevelRule rule;
	rule.is_by_error = options.levels.is_empty() && has_parts(options);
	rule.pixel_error = pixel_error_of(options);
	rule.lod_bias = range.lod_bias;
	rule.fade_ratio = float(options.fade_ratio);
	rule.range_end = range.end;
	rule.shadow_distance = float(options.shadow_distance);
	// In a shadow pass of Compatibility, shaders measure distances from the light, not from the camera.
	rule.has_near_shadows = !is_compatibility();
	const bool is_rectangle = options.map.is_null() && options.outline.is_empty() && !options.endless;
	rule.area = is_rectangle ? options.size.x * options.size.y : 0.0f;
	rule.is_wider = options.view_distance <= 0.0;
	return rule;
}

std::vector<FieldLevel> read_levels(const FieldProperties &options, const SightRange &range) {
	const std::vector<ListedLevel> listed = list_levels(options);
	const LevelRule rule = read_level_rule(options, range);
	std::vector<FieldLevel> made;
	for (size_t i = 0; i < listed.size(); i++) {
		FieldLevel level;
		level.lod = listed[i].segments;
		level.begin = i > 0 ? made.back().end : 0.0f;
		level.end = listed[i].end * range.lod_bias;
		const bool is_last =
				i + 1 == listed.size() || level.end <= level.begin || (range.end > 0.0f && level.end >= range.end);
		level.lod_density = rule.is_by_error
				? USUAL_THINNING.scaled(range.lod_bias)
				: density_between(i > 0 ? &made.back().lod_density : nullptr, level.begin, level.end, listed[i].share);
		level.affects_lathes = !options.levels.is_empty();
		level.end = is_last ? range.end : level.end;
		level.margin = std::max(rule.fade_ratio * level.begin, MIN_MARGIN);
		level.end_margin = std::max(rule.fade_ratio * level.end, MIN_MARGIN);
		level.halvings = rule.is_by_error ? halvings_by_error(level.lod) : int(i);
		level.shadow_end = rule.shadow_distance * range.lod_bias;
		level.casts_shadows = level.begin < level.shadow_end;
		// With a view distance, tiles come and go alone.
		fit_tiles(level, float(options.tile_size), rule.is_wider);
		made.push_back(level);
		if (is_last && !rule.is_by_error) {
			break; // Nothing is visible beyond it.
		}
		level.end = rule.is_by_error ? listed[i].end * range.lod_bias : level.end;
		made.back().end = level.end;
	}
	return made;
}

} // namespace undergrowth

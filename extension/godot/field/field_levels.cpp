// Reads the levels of detail that users set, or the defaults.

#include "field/build_input.hpp"

#include <algorithm>

using namespace godot;

namespace undergrowth {

static constexpr int MAX_TILE_FACTOR = 4;
static constexpr int MAX_TILE_CUTS = 4;
// Fractions of the distance at which a level ends. Larger tiles are divided; squares of several tiles are at most this
// wide.
static constexpr float MAX_TILE_SHARE = 0.75f;
static constexpr float MAX_SQUARE_SHARE = 0.6f;
static constexpr float MIN_MARGIN = 1e-3f; // m.
static constexpr float MIN_BIAS = 0.01f;

SightRange sight_range_of(const GeometryInstance3D *node) {
	return { float(node->get_visibility_range_end()), std::max(float(node->get_lod_bias()), MIN_BIAS) };
}

String find_level_fault(const ViewOptions &options) {
	float before = 0.0f;
	for (int64_t i = 0; i < options.levels.size(); i++) {
		const Ref<PlantFieldLevel> level = options.levels[i];
		const String name = "levels[" + String::num_int64(i) + "]";
		if (level.is_null()) {
			return name + String(" is empty. Set a PlantFieldLevel there, or remove the entry.");
		}
		const float end = float(level->get_end());
		const bool has_end = end > 0.0f || i + 1 < options.levels.size();
		if (has_end && end <= before) {
			return name + String(" ends at ") + String::num(end) +
					" m, not beyond the one before it. Let each level end farther away than the one before; the last "
					"alone may end at 0, which is never.";
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
		return { { 6, 7.0f, 1.0f }, { 3, 18.0f, 0.65f }, { 2, 45.0f, 0.25f }, { 2, 0.0f, 0.1f } };
	}
	return { { 12, 12.0f, 1.0f }, { 6, 25.0f, 1.0f }, { 3, 50.0f, 1.0f }, { 2, 0.0f, 1.0f } };
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

// Squares are small near the camera, where levels are short and plants have many vertices, and large far away.
static void fit_tiles(FieldLevel &level, float tile_size, bool is_wider) {
	const float end = level.end > 0.0f ? level.end : 2.0f * level.begin;
	while (is_wider && level.tile_factor < MAX_TILE_FACTOR &&
			2.0f * tile_size * float(level.tile_factor) <= MAX_SQUARE_SHARE * end) {
		level.tile_factor *= 2;
	}
	while (end > 0.0f && level.tile_cuts < MAX_TILE_CUTS && tile_size > MAX_TILE_SHARE * end * float(level.tile_cuts)) {
		level.tile_cuts *= 2;
	}
}

std::vector<FieldLevel> read_levels(const FieldProperties &options, const SightRange &range) {
	const std::vector<ListedLevel> listed = list_levels(options);
	std::vector<FieldLevel> made;
	for (size_t i = 0; i < listed.size(); i++) {
		FieldLevel level;
		level.lod = listed[i].segments;
		level.begin = i > 0 ? made.back().end : 0.0f;
		level.end = listed[i].end * range.lod_bias;
		const bool is_last =
				i + 1 == listed.size() || level.end <= level.begin || (range.end > 0.0f && level.end >= range.end);
		level.lod_density =
				density_between(i > 0 ? &made.back().lod_density : nullptr, level.begin, level.end, listed[i].share);
		level.affects_lathes = !options.levels.is_empty();
		level.end = is_last ? range.end : level.end;
		level.margin = std::max(float(options.fade_margin), MIN_MARGIN);
		level.casts_shadows = level.begin < options.shadow_distance * double(range.lod_bias);
		// With a view distance, tiles come and go alone.
		fit_tiles(level, float(options.tile_size), options.view_distance <= 0.0);
		made.push_back(level);
		if (is_last) {
			break; // Nothing is visible beyond it.
		}
	}
	return made;
}

} // namespace undergrowth

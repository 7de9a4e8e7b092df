// Chooses the distances of the levels of each species by the error of its outline, and by the triangles that are drawn.

#include "field/view/field_fitting.hpp"

#include "conventions.hpp"
#include "mesh/form_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

using namespace godot;

namespace undergrowth {

static constexpr int MAX_TILE_FACTOR = 4;
static constexpr int MAX_TILE_CUTS = 4;
// Fractions of the distance at which a level ends. Larger tiles are divided; squares of several tiles are at most this
// wide.
static constexpr float MAX_TILE_SHARE = 0.75f;
static constexpr float MAX_SQUARE_SHARE = 0.6f;
static constexpr float MIN_MARGIN = 1e-3f; // m.

// Pixels per radian in the middle of a picture of 1080 lines with a vertical angle of view of 75°.
static constexpr float PIXELS_OF_RADIAN = 703.7f;
static constexpr float NEAREST = 0.5f; // m: a level that ends nearer is not used.
static constexpr float NEAREST_CARDS = 0.55f; // m.
static constexpr float MAX_SHARE_OF_NEXT = 0.7f; // Largest begin of a level, as a share of its end.
// The same for solid levels after one with cards that begin nearer than SOLID_SEEN_END (m). Their forms visibly differ.
static constexpr float MAX_SOLID_SHARE_OF_NEXT = 0.5f;
static constexpr float SOLID_SEEN_END = 5.0f;
// The same for levels with cards of plants of many parts. Between the form of the nearest plants and a level with few
// segments, they would be seen for a short way, and with gaps.
static constexpr float MAX_SHARE_WITH_CLOSEST = 0.6f;
static constexpr float BODIES_SEEN_END = 12.0f; // m.
static constexpr float NEAREST_BODIES = 2.0f; // m, of forms with many bodies:
static constexpr int MIN_SEGMENTS_OF_BODIES = 5;
static constexpr float NEAR_END = 20.0f; // m: levels that end farther are drawn in squares.
// m: a level that begins nearer, and is drawn plant by plant, has this many variants. A plant must not become another
// one where its stems can be counted.
static constexpr float DISTINCT_END = 4.5f;
static constexpr int DISTINCT_VARIANTS = 2;
static constexpr float MAX_NEAR_PLANTS = 12000.0f; // Within the end of a level that is drawn plant by plant.
static constexpr int SHADOW_SEGMENTS = 3; // Finer levels cast no shadows.
static constexpr float NEAR_SHADOWS = 3.0f; // m: to there, dense species cast shadows of more than the last level.
static constexpr float MAX_SHADOW_VERTICES = 600.0f; // Per m², of a species that is not dense.
static constexpr int MIN_SEGMENTS_OF_NEAR = 3; // Coarser levels of plants of parts are drawn in squares.

static constexpr int NO_VARIANTS = 30; // Halvings.
static constexpr int DRAFT_SEGMENTS = 5; // Few vertices, but parts are drawn one by one.

// Triangles in view of a whole field, if it has this area or more (m²). Above that, levels change nearer than their
// error alone demands.
static constexpr float MAX_TRIANGLES = 0.85e6f;
static constexpr float LARGE_AREA = 400.0f;
// Fractions of a full circle: what a camera sees at once of single plants, and of squares.
static constexpr float SEEN_SHARE = 0.36f;
static constexpr float SEEN_SHARE_OF_SQUARES = 0.65f;
static constexpr float SEEN_SHARE_OF_FIELD = 0.75f;
static constexpr float MAX_COARSENING = 64.0f;
static constexpr float COARSENED_FROM = 1.5f; // m.
// A last level of bodies with larger errors than both, as a share of the height and in metres, is a lump.
static constexpr float LUMP = 0.4f;
static constexpr float MIN_LUMP = 0.1f;
static constexpr float MAX_COARSENING_OF_LUMPS = 3.0f;
// Beyond it, the nearest plants of a dense field have cards, too.
static constexpr float MAX_COARSENING_OF_SOLID = 2.0f;

// Distances (m) at which levels of plants without parts begin, by segments.
static float lathe_begin(int segments) {
	return segments > 12 ? 0.0f : segments >= 8 ? 6.0f : segments >= 5 ? 14.0f : segments >= 3 ? 28.0f : 50.0f;
}

void fit_tiles(FieldLevel &level, float tile_size, bool is_wider) {
	const float end = level.end > 0.0f ? level.end : 2.0f * level.begin;
	level.tile_factor = level.tile_cuts = 1;
	while (is_wider && level.tile_factor < MAX_TILE_FACTOR &&
			2.0f * tile_size * float(level.tile_factor) <= MAX_SQUARE_SHARE * end) {
		level.tile_factor *= 2;
	}
	while (end > 0.0f && level.tile_cuts < MAX_TILE_CUTS && tile_size > MAX_TILE_SHARE * end * float(level.tile_cuts)) {
		level.tile_cuts *= 2;
	}
}

// Ears and panicles on cards do not become bodies where those are seen, even if their outline is better. The nearest
// distance (m) of a level with bodies, 0 without them.
static float begin_of_bodies(const FieldRenderSetup &setup, const SpeciesStyle &style, size_t level) {
	if (level + 1 >= setup.levels.size() || !style.has_cards_before(level) || !style.have_bodies[level]) {
		return 0.0f;
	}
	return setup.levels[level].lod < MIN_SEGMENTS_OF_BODIES ? BODIES_SEEN_END : NEAREST_BODIES;
}

// The nearest distance (m) of a level with cards: its texels are as large as the allowed error, and solid plants are
// nearer.
static float begin_of_cards(const LevelRule &rule, const SpeciesStyle &style) {
	const float sharp = style.texel * style.mean_scale * PIXELS_OF_RADIAN * float(style.detail) / rule.pixel_error;
	return std::max(sharp, NEAREST_CARDS);
}

// Errors of the levels that may be the first one. The one with the smallest error is, because a form may be worse than
// a coarser one.
static std::vector<float> errors_of_first(const SpeciesStyle &style, bool is_solid) {
	std::vector<float> errors = style.errors;
	for (size_t i = 0; i < style.are_carded.size() && is_solid; i++) {
		errors[i] = style.are_carded[i] ? std::numeric_limits<float>::max() : errors[i];
	}
	return errors;
}

// True for a last level of bodies that are as coarse as the plant, as of a tuft of many heads.
static bool is_lump(const SpeciesStyle &style, size_t level) {
	return level + 1 == style.errors.size() && style.have_bodies[level] &&
			style.errors[level] > std::max(LUMP * style.mean_height(), MIN_LUMP);
}

// Begins of all levels (m), ascending. From COARSENED_FROM on the error may be `coarser` times as large: equal errors
// at all distances are the smallest ones for a number of triangles. Nearer plants are few, and keep more of their
// forms.
static std::vector<float> begins_of(const FieldRenderSetup &setup, const SpeciesStyle &style, float coarser) {
	const LevelRule &rule = setup.rule;
	const bool is_first_solid = coarser <= MAX_COARSENING_OF_SOLID && !style.are_carded.empty() && !style.are_carded[0];
	std::vector<float> begins;
	for (size_t i = 0; i < setup.levels.size(); i++) {
		const bool has_error = i < style.errors.size();
		const float own = has_error
				? style.errors[i] * style.mean_scale * PIXELS_OF_RADIAN * float(style.detail) / rule.pixel_error
				: lathe_begin(setup.levels[i].lod);
		const float most = is_lump(style, i) ? std::min(coarser, MAX_COARSENING_OF_LUMPS) : coarser;
		const float factor = 1.0f + (most - 1.0f) * std::min(own / COARSENED_FROM, 1.0f);
		const bool is_carded = is_first_solid && style.are_carded[i];
		const float least = is_carded ? begin_of_cards(rule, style) : begin_of_bodies(setup, style, i);
		begins.push_back(i == 0 ? 0.0f : std::max(own / factor, least) * rule.lod_bias);
	}
	for (size_t i = begins.size() - 1; i-- > 0;) {
		begins[i] = std::min(begins[i], begins[i + 1]);
	}
	const std::vector<float> errors = errors_of_first(style, is_first_solid);
	const auto best = std::min_element(errors.begin(), errors.end()) - errors.begin();
	if (!errors.empty()) {
		std::fill(begins.begin(), begins.begin() + best + 1, 0.0f);
	}
	return begins;
}

// A level that begins later than at this share of its end is not used.
static float max_share_of_next(const LevelRule &rule, const SpeciesStyle &style, size_t level, float begin) {
	if (style.closest > 0 && style.are_carded[level]) {
		return MAX_SHARE_WITH_CLOSEST;
	}
	const bool is_after_cards = style.has_cards_before(level) && begin < SOLID_SEEN_END * rule.lod_bias;
	return is_after_cards ? MAX_SOLID_SHARE_OF_NEXT : MAX_SHARE_OF_NEXT;
}

// Marks the levels that a species uses, and sets their distances.
static void set_distances(const LevelRule &rule, const SpeciesStyle &style, const std::vector<float> &begins,
		std::vector<FieldLevel> &levels) {
	float next = rule.range_end;
	bool is_last = true;
	for (size_t i = levels.size(); i-- > 0;) {
		FieldLevel &level = levels[i];
		const bool is_beyond = rule.range_end > 0.0f && begins[i] >= rule.range_end;
		const float max_share = max_share_of_next(rule, style, i, begins[i]);
		const bool is_short = !is_last && (next <= NEAREST || begins[i] >= max_share * next);
		level.is_used = i == 0 ? is_last || next > NEAREST : !is_beyond && !is_short;
		level.begin = level.is_used ? begins[i] : 0.0f;
		level.end = level.is_used ? next : 0.0f;
		level.margin = std::max(rule.fade_ratio * level.begin, MIN_MARGIN);
		level.end_margin = std::max(rule.fade_ratio * level.end, MIN_MARGIN);
		next = level.is_used ? level.begin : next;
		is_last = is_last && !level.is_used;
	}
	const auto first = std::find_if(levels.begin(), levels.end(), [](const FieldLevel &one) { return one.is_used; });
	first->begin = 0.0f;
	first->margin = MIN_MARGIN;
}

// Chooses the levels that are drawn plant by plant: those with few plants.
static void set_near(const LevelRule &rule, const SpeciesStyle &style, std::vector<FieldLevel> &levels) {
	for (FieldLevel &level : levels) {
		const float around = float(PI) * level.end * level.end;
		const float plants = style.density * (rule.area > 0.0f ? std::min(around, rule.area) : around);
		level.is_near = level.is_used && level.lod >= MIN_SEGMENTS_OF_NEAR && level.end > 0.0f &&
				level.end <= NEAR_END && plants <= MAX_NEAR_PLANTS;
		level.min_variants = level.is_near && level.begin < DISTINCT_END * rule.lod_bias ? DISTINCT_VARIANTS : 1;
	}
}

// Density of the plants that cast shadows. The others are wider.
static const LodDensity DENSITY_OF_SHADOWS = { { 3.5f, 9.0f, 27.0f }, { 1.0f, 0.33f, 0.08f } };

// A level with few vertices casts the shadows of the nearest plants, and the last level those of the others.
static void set_casters(const LevelRule &rule, SpeciesStyle &style, std::vector<FieldLevel> &levels) {
	const float end = rule.shadow_distance * rule.lod_bias;
	const auto last = std::find_if(levels.rbegin(), levels.rend(), [](const FieldLevel &one) { return one.is_used; });
	const auto near = std::find_if(levels.begin(), levels.end(),
			[](const FieldLevel &one) { return one.is_used && one.lod <= SHADOW_SEGMENTS; });
	const bool is_dense = style.density * float(vertex_budget(SHADOW_SEGMENTS)) > MAX_SHADOW_VERTICES;
	const float near_end = is_dense ? NEAR_SHADOWS * rule.lod_bias : near != levels.end() ? near->end : 0.0f;
	style.casters = {};
	for (FieldLevel &level : levels) {
		level.casts_shadows = false;
	}
	if (end <= 0.0f) {
		return;
	}
	const LodDensity lod_density = DENSITY_OF_SHADOWS.scaled(rule.lod_bias);
	float begin = 0.0f;
	if (rule.has_near_shadows && near != levels.end() && &*near != &*last) {
		begin = std::min(near_end, end);
		style.casters[0] = { int(near - levels.begin()), 0.0f, begin, lod_density };
	}
	if (begin < end) {
		style.casters[1] = { int(&*last - levels.data()), begin, end, lod_density };
	}
}

// Each level of a model casts its own shadows, with the cut-out of its textures. Tall plants are thinned farther away.
static void set_for_model(const SpeciesStyle &style, std::vector<FieldLevel> &levels) {
	static constexpr float LOW = 0.5f; // m: height of plants that are thinned as those of parts.
	const float taller = std::max(style.mean_height() * style.mean_scale / LOW, 1.0f);
	const bool has_one = style.has_one_model();
	for (FieldLevel &level : levels) {
		level.halvings = has_one ? NO_VARIANTS : level.halvings;
		level.min_variants = has_one ? 1 : style.variant_count;
		level.casts_shadows = level.is_used;
		level.lod_density = level.lod_density.scaled(taller);
	}
}

static std::vector<FieldLevel> fitted(const FieldRenderSetup &setup, SpeciesStyle &style, float coarser) {
	const LevelRule &rule = setup.rule;
	std::vector<FieldLevel> levels = setup.levels;
	set_distances(rule, style, begins_of(setup, style, coarser), levels);
	if (style.model()) {
		set_for_model(style, levels);
	} else if (!style.errors.empty()) {
		set_near(rule, style, levels);
		set_casters(rule, style, levels);
	}
	for (FieldLevel &level : levels) {
		level.casts_shadows = level.is_used && level.casts_shadows && level.begin < level.shadow_end;
		fit_tiles(level, setup.tile_size, rule.is_wider);
	}
	return levels;
}

// The ground (m²) on which a camera in the middle of the field draws the plants of a level up to this distance. Single
// plants are also drawn beside and behind the camera, where their tops can lean into view. Squares are drawn whole.
static float ground_in_view(const LevelRule &rule, const SpeciesStyle &style, bool is_near, float distance) {
	const float circle = float(PI) * distance * distance;
	const float reach = style.mean_height() * style.mean_scale;
	const float beside = 2.0f * reach * distance + 0.5f * float(PI) * reach * reach;
	const float seen = is_near ? std::min(SEEN_SHARE * circle + beside, circle) : SEEN_SHARE_OF_SQUARES * circle;
	return rule.area > 0.0f ? std::min(seen, SEEN_SHARE_OF_FIELD * rule.area) : seen;
}

// The triangles that a camera in the middle of the field draws of a species, without its last level.
static float triangles_in_view(
		const FieldRenderSetup &setup, const SpeciesStyle &style, const std::vector<FieldLevel> &levels) {
	float sum = 0.0f;
	for (size_t i = 0; i < levels.size(); i++) {
		const FieldLevel &level = levels[i];
		if (level.is_used && level.end > 0.0f) {
			const float share = level.lod_density.density_at(0.5f * (level.begin + level.end));
			const float from = std::max(level.begin - level.margin, 0.0f);
			const float nearer = level.is_near ? ground_in_view(setup.rule, style, true, from) : 0.0f;
			const float drawn = ground_in_view(setup.rule, style, level.is_near, level.end) - nearer;
			const bool is_closest = i == 0 && style.closest > 0;
			const float triangles = is_closest ? style.usual_triangles : style.triangles_at(i);
			sum += style.density * share * triangles * drawn;
		}
	}
	return sum;
}

// The smallest factor of the error with at most this number of triangles, within a tenth.
static float coarsening_for(const FieldRenderSetup &setup, SpeciesStyle &style, float max) {
	float coarser = 1.0f;
	while (coarser < MAX_COARSENING && triangles_in_view(setup, style, fitted(setup, style, coarser)) > max) {
		coarser *= 1.1f;
	}
	return coarser;
}

void fit_levels(const FieldRenderSetup &setup, SpeciesStyle &style) {
	style.levels = setup.rule.is_by_error ? fitted(setup, style, 1.0f) : setup.levels;
}

void fit_drafts(FieldRenderSetup &setup) {
	const auto is_draft = [](const FieldLevel &level) { return level.lod <= DRAFT_SEGMENTS; };
	for (SpeciesStyle &style : setup.styles) {
		if (!style.is_by_error) {
			fit_levels(setup, style);
			continue;
		}
		std::vector<FieldLevel> levels = setup.levels;
		const auto drawn = std::find_if(levels.begin(), levels.end() - 1, is_draft);
		for (auto level = levels.begin(); level != levels.end(); ++level) {
			level->is_used = level == drawn;
			level->begin = 0.0f;
			level->end = level->is_used ? setup.rule.range_end : 0.0f;
			level->margin = level->end_margin = MIN_MARGIN;
			level->halvings = NO_VARIANTS;
			level->casts_shadows = false;
			fit_tiles(*level, setup.tile_size, setup.rule.is_wider);
		}
		if (style.model()) {
			set_for_model(style, levels);
		} else {
			set_casters(setup.rule, style, levels);
		}
		style.levels = std::move(levels);
	}
}

// Divides the triangles so that the errors, weighted by the root of the densities, have the smallest sum: triangles are
// as the inverse square of the factor of the error. What a species does not need is left for those that need more.
void fit_levels(FieldRenderSetup &setup) {
	struct Share {
		SpeciesStyle *style;
		float need, weight;
	};
	std::vector<Share> shares;
	float weights = 0.0f;
	for (SpeciesStyle &style : setup.styles) {
		fit_levels(setup, style);
		if (setup.rule.is_by_error && !style.errors.empty() && style.density > 0.0f) {
			const std::vector<FieldLevel> levels = fitted(setup, style, 1.0f);
			const float need = triangles_in_view(setup, style, levels);
			shares.push_back({ &style, need, std::cbrt(need * style.density) });
			weights += shares.back().weight;
		}
	}
	std::stable_sort(shares.begin(), shares.end(),
			[](const Share &one, const Share &other) { return one.need * other.weight < other.need * one.weight; });
	const float part = setup.rule.area > 0.0f ? std::min(setup.rule.area / LARGE_AREA, 1.0f) : 1.0f;
	float left = MAX_TRIANGLES * std::sqrt(part) * setup.rule.lod_bias * setup.rule.lod_bias;
	for (const Share &share : shares) {
		const float max = left * share.weight / weights;
		if (share.need > max) {
			const float coarser = coarsening_for(setup, *share.style, max);
			share.style->levels = fitted(setup, *share.style, coarser);
		}
		left -= std::min(share.need, max);
		weights -= share.weight;
	}
}

} // namespace undergrowth

#include "field/view/species_styles.hpp"

#include "base/random.hpp"
#include "base/stopwatch.hpp"
#include "card/card_mips.hpp"
#include "field/view/field_levels.hpp"
#include "field/view/field_material.hpp"
#include "form/grown_plant.hpp"
#include "form/shared_cards.hpp"
#include "mesh/form_plan.hpp"
#include "model/plant_model.hpp"
#include "placement/plant_axes.hpp"
#include "plant/base_shape.hpp"
#include "species/shared_resources.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace godot;

namespace undergrowth {

static constexpr size_t MEASURED_VARIANTS = 3;
static constexpr float CARD_SHARE = 2.0f / 3.0f; // Of their error: three pixels in place of two.
static constexpr float BODY_SHARE = 3.0f;
static constexpr float TEXELS = 2.0f; // As an error: a texel is at most half of the allowed pixels.
static constexpr float SHARPEST = 0.0018f; // m, as an error: nearer, parts are seen to be flat.
static constexpr float MIN_CARD_GAIN = 0.85f;
static constexpr float MIN_GAIN_AFTER_CARDS = 1.25f; // A change from cards to solid parts is seen.
static constexpr int CLOSEST_SEGMENTS = 33; // Of the first level of plants of many parts,
static constexpr int MANY_PARTS = 64; // which need more than the vertices of this number of segments.
static constexpr float MAX_CLOSEST_ERROR = 0.004f; // m: plumes and fronds that this form cannot show stay on cards.
static constexpr float MAX_CLOSEST_DENSITY = 50.0f; // Plants/m²: this form may exceed the number of triangles in view.

static int64_t variant_seed(int64_t seed, int variant) {
	return int64_t(mix_bits(uint64_t(seed) ^ mix_bits(uint64_t(variant))) >> 1);
}

int SpeciesStyle::segments_at(const FieldLevel &level) const {
	if (!is_by_error) {
		return std::clamp(int(std::lround(detail * level.lod)), MIN_LOD, MAX_LOD);
	}
	return closest > 0 && level.lod == levels.front().lod ? closest : level.lod;
}

Ref<Material> SpeciesStyle::drawn_material(const Ref<Material> &material_override) const {
	return material_override.is_valid() ? material_override : function->get_material();
}

bool SpeciesStyle::needs_other_meshes(const Ref<Material> &material) const {
	if (model()) {
		return false;
	}
	return (is_by_error && takes_cards != draws_cards(material)) ||
			(has_parts() && is_packed != reads_packed_vertices(material));
}

Ref<Material> SpeciesStyle::present_material(const Ref<Material> &material_override) const {
	const Ref<Material> material = drawn_material(material_override);
	if (!needs_other_meshes(material)) {
		return material;
	}
	return needs_other_meshes(sampled_material) ? Ref<Material>() : sampled_material;
}

String SpeciesStyle::sample_next(
		const std::vector<FieldLevel> &given, bool by_error, const Ref<Material> &material_override) {
	const int variant = int(variants.size());
	levels = given;
	if (variant == variant_count) {
		read_traits();
		unsolved_stem = function->describe_stem(mean_height());
		shared_stem = unsolved_stem ? SharedStem::of(*unsolved_stem) : nullptr;
		take_stem(unsolved_stem ? nullptr : function->find_stem(mean_height(), in_air));
		return String();
	}
	const int64_t own_seed = variant_seed(seed, variant);
	samples.resize(levels.size());
	for (size_t level = 0; level < levels.size(); level++) {
		const bool has_parts = level > 0 && samples[0][size_t(variant)].has_parts();
		if (!has_parts && variant >= levels[level].groups(variant_count)) {
			break;
		}
		SampledPlant sampled;
		if (has_parts) {
			sampled = samples[0][size_t(variant)]; // A plant of parts is the same at all levels.
			sampled.lod = segments_at(levels[level]);
		} else {
			const String problem = function->sample(0.0, segments_at(levels[level]), own_seed, sampled);
			if (!problem.is_empty()) {
				return problem;
			}
		}
		if (level == 0) {
			is_by_error = by_error && sampled.has_parts();
			take_needs(sampled, drawn_material(material_override));
			sampled.lod = sampled.has_parts() ? segments_at(levels[level]) : sampled.lod;
			variants.push_back({ own_seed, sampled.height });
		}
		samples[level].push_back(std::move(sampled));
	}
	return String();
}

// All variants have meshes of the same kind, even if the material changes between two of them.
void SpeciesStyle::take_needs(SampledPlant &sampled, const Ref<Material> &material) {
	if (variants.empty()) {
		sampled_material = material;
		takes_cards = is_by_error && sampled.grown && draws_cards(material);
		cards = takes_cards ? function->find_cards() : nullptr;
		is_packed = sampled.grown && reads_packed_vertices(material);
	}
	sampled.is_packed = is_packed;
	has_orders = has_orders || (is_packed && sampled.grown->has_orders);
}

bool SpeciesStyle::load_next_shader(bool is_draft) const {
	return load_next_field_shader(motion.has_parts, cards && !is_draft, has_orders);
}

// The largest error of some variants: a single one may lack flowers, and then has no cards.
LevelLooks SpeciesStyle::measure_level(size_t level, bool has_cards, std::vector<std::optional<LevelError>> &outlines) {
	LevelLooks worst;
	for (size_t variant = 0; variant < outlines.size(); variant++) {
		const GrownPlant &grown = *samples[0][variant].grown;
		SampledPlant sampled = samples[0][variant];
		sampled.lod = segments_at(levels[level]);
		sampled.cards = has_cards ? cards : nullptr;
		const LevelLooks looks = grown.level_looks(sampled.lod, has_cards, [&]() -> LevelLooks {
			if (!outlines[variant]) {
				outlines[variant].emplace(measure_outline(grown.form));
			}
			measured.push_back(SharedMesh::of(sampled));
			measured.back()->build();
			SharedMesh &mesh = *measured.back();
			return { mesh.outline_error(*outlines[variant]), mesh.has_bodies(), mesh.has_cards(), mesh.triangles() };
		});
		worst.triangles += looks.triangles / int(outlines.size());
		worst.error = std::max(worst.error, looks.error);
		worst.has_bodies = worst.has_bodies || looks.has_bodies;
		worst.has_cards = worst.has_cards || looks.has_cards;
	}
	return worst;
}

// A texture shows the true shapes where its outline is a few pixels off, so that cards may be less exact than solid
// parts, if no bodies are beside them. Nearer than their texels allow, they are blurred. They cost more pixels and must
// be better by a margin. A body in place of open parts looks wrong, even if its outline is better.
void SpeciesStyle::measure_cards(size_t level, std::vector<std::optional<LevelError>> &outlines, bool has_bodies) {
	const float sharpest = std::max(TEXELS * texel_of(cards->sheet()), SHARPEST);
	const float gain = has_cards_before(level) ? MIN_GAIN_AFTER_CARDS : MIN_CARD_GAIN;
	const float most = gain * (has_bodies ? BODY_SHARE : 1.0f) * errors[level];
	if (sharpest >= most) {
		return; // Cards are not measured where their texels alone are too large.
	}
	const LevelLooks looks = measure_level(level, true, outlines);
	if (!looks.has_cards) {
		return;
	}
	const float own = (looks.has_bodies ? 1.0f : CARD_SHARE) * looks.error;
	const float finest = *std::min_element(errors.begin(), errors.end());
	const float blurred = std::max(own, sharpest);
	const float allowed = std::max(blurred, std::min(own / CARD_SHARE, finest));
	are_carded[level] = (has_bodies ? blurred : allowed) < most;
	errors[level] = are_carded[level] ? std::min(allowed, errors[level]) : errors[level];
	triangles[level] = are_carded[level] ? float(looks.triangles) : triangles[level];
}

// The nearest plants are geometry, because holes and teeth of a few texels are seen there. Plants of more parts than
// the usual first form can show get a finer one where they are not many.
void SpeciesStyle::measure_closest(float solid_triangles, std::vector<std::optional<LevelError>> &outlines) {
	const bool has_many = std::any_of(
			samples[0].begin(), samples[0].begin() + std::ptrdiff_t(outlines.size()), [](const SampledPlant &sampled) {
				const GrownPlant &grown = *sampled.grown;
				return plan_form(grown.form, grown.measure(), vertex_budget(MANY_PARTS)).is_cut;
			});
	closest = has_many && density <= MAX_CLOSEST_DENSITY ? CLOSEST_SEGMENTS : 0;
	const LevelLooks looks = measure_level(0, false, outlines);
	if (looks.error > MAX_CLOSEST_ERROR) {
		closest = 0;
		return;
	}
	for (SampledPlant &sampled : samples[0]) {
		sampled.lod = segments_at(levels[0]);
	}
	are_carded[0] = false;
	errors[0] = looks.error;
	usual_triangles = solid_triangles;
	triangles[0] = float(looks.triangles);
	have_bodies[0] = looks.has_bodies;
}

void SpeciesStyle::measure_forms(size_t level, bool has_cards, std::vector<std::optional<LevelError>> &outlines) {
	const LevelLooks solid = measure_level(level, false, outlines);
	errors[level] = solid.error;
	triangles[level] = float(solid.triangles);
	have_bodies[level] = solid.has_bodies;
	if (has_cards) {
		measure_cards(level, outlines, solid.has_bodies);
	}
	if (level == 0 && are_carded[0]) {
		measure_closest(float(solid.triangles), outlines);
	}
}

// Levels for solid plants are only measured if no level has cards.
void SpeciesStyle::measure() {
	if (!is_by_error || samples.empty()) {
		return;
	}
	if (samples[0][0].model) {
		measure_models();
		return;
	}
	const bool has_cards = cards && !cards->sheet().is_empty();
	std::vector<std::optional<LevelError>> outlines(std::min(samples[0].size(), MEASURED_VARIANTS));
	are_carded.assign(samples.size(), false);
	errors.assign(samples.size(), std::numeric_limits<float>::infinity());
	triangles.assign(samples.size(), 0.0f);
	have_bodies.assign(samples.size(), false);
	for (const bool is_for_all : { true, false }) {
		const bool are_solid = std::none_of(are_carded.begin(), are_carded.end(), [](bool one) { return one; });
		for (size_t level = 0; level < samples.size() && (is_for_all || are_solid); level++) {
			if (is_for_all == !is_for_solids(segments_at(levels[level]))) {
				measure_forms(level, has_cards && is_for_all, outlines);
			}
		}
	}
	texel = has_cards ? texel_of(cards->sheet()) : 0.0f;
	for (size_t level = 0; level < samples.size(); level++) {
		for (SampledPlant &sampled : samples[level]) {
			sampled.cards = are_carded[level] ? cards : nullptr;
		}
	}
}

bool SpeciesStyle::is_measured() const {
	if (!is_by_error || samples.empty() || samples[0][0].model) {
		return true;
	}
	for (size_t variant = 0; variant < std::min(samples[0].size(), MEASURED_VARIANTS); variant++) {
		for (const FieldLevel &level : levels) {
			const int segments = segments_at(level);
			if (!is_for_solids(segments) && !samples[0][variant].grown->knows_looks(segments)) {
				return false;
			}
		}
	}
	return true;
}

void SpeciesStyle::measure_models() {
	are_carded.assign(samples.size(), false);
	have_bodies.assign(samples.size(), false);
	for (const FieldLevel &level : levels) {
		float worst = 0.0f;
		for (const SampledPlant &sampled : samples[0]) {
			worst = std::max(worst, sampled.model->error(segments_at(level)));
		}
		errors.push_back(worst);
	}
}

static const SampledPlant *first_sample(const SpeciesStyle &style) {
	const std::vector<SampledPlant> *from = style.samples.empty() ? &style.nearest : &style.samples[0];
	from = from->empty() ? &style.nearest : from;
	return from->empty() ? nullptr : &from->front();
}

const PlantModel *SpeciesStyle::model() const {
	const SampledPlant *first = first_sample(*this);
	return first ? first->model.get() : nullptr;
}

bool SpeciesStyle::has_one_model() const {
	const std::vector<SampledPlant> &all = samples.empty() || samples[0].empty() ? nearest : samples[0];
	return std::all_of(all.begin(), all.end(), [&](const SampledPlant &one) { return one.model == all.front().model; });
}

bool SpeciesStyle::has_cards_before(size_t level) const {
	return level < are_carded.size() && !are_carded[level] &&
			std::count(are_carded.begin(), are_carded.begin() + std::ptrdiff_t(level), true) > 0;
}

float SpeciesStyle::triangles_at(size_t level) const {
	const PlantModel *own = model();
	return own ? float(own->triangles(segments_at(levels[level]))) : triangles[level];
}

void SpeciesStyle::find_sources() {
	sources.clear();
	surface_sources.assign(samples.size(), {});
	for (size_t level = 0; level < samples.size(); level++) {
		for (const SampledPlant &sampled : samples[level]) {
			std::vector<Ref<Material>> own;
			sampled.model->list_materials(sampled.lod, own);
			surface_sources[level].emplace_back();
			for (const Ref<Material> &material : own) {
				const auto known = std::find(sources.begin(), sources.end(), material);
				surface_sources[level].back().push_back(size_t(known - sources.begin()));
				if (known == sources.end()) {
					sources.push_back(material);
				}
			}
		}
	}
}

Ref<Material> SpeciesStyle::source_material(size_t source, const Ref<Material> &material_override) const {
	const Ref<Material> own = drawn_material(material_override);
	return own.is_valid() ? own : sources[source];
}

RID SpeciesStyle::override_for(size_t material) const {
	return model() ? RID() : materials[material]->get_rid();
}

void SpeciesStyle::set_surface_materials() const {
	for (size_t level = 0; level < meshes.size() && model(); level++) {
		for (size_t group = 0; group < meshes[level].size(); group++) {
			const std::vector<size_t> &own = surface_sources[level][group];
			for (size_t surface = 0; surface < own.size(); surface++) {
				meshes[level][group]->surface_set_material(int(surface), materials[own[surface] * slots() + level]);
			}
		}
	}
}

size_t SpeciesStyle::level_of(size_t material) const {
	return material < levels.size() ? material : size_t(std::max(casters[material - levels.size()].level, 0));
}

bool SpeciesStyle::is_carded(size_t material) const {
	const size_t level = level_of(material);
	return level < are_carded.size() && are_carded[level];
}

// The nearest plants swing in the shadows, too.
DrawnParts SpeciesStyle::drawn_parts(size_t material) const {
	if (is_carded(material)) {
		return has_orders ? DrawnParts::orders_with_cards : DrawnParts::with_cards;
	}
	if (material > levels.size()) {
		return DrawnParts::shadows;
	}
	return has_orders ? DrawnParts::orders : DrawnParts::solid;
}

// Plants of parts are sampled with all variants at all levels. The samples of the first used level are kept for plants
// that get a mesh of their own.
void SpeciesStyle::leave_unused() {
	for (size_t level = 0; level < samples.size(); level++) {
		if (!levels[level].is_used) {
			samples[level].clear();
			continue;
		}
		samples[level].resize(std::min(samples[level].size(), size_t(levels[level].groups(variant_count))));
		nearest = nearest.empty() ? samples[level] : nearest;
	}
}

void SpeciesStyle::build() {
	solve_stem();
	if (samples.empty()) {
		return;
	}
	leave_unused();
	build_meshes();
	if (model()) {
		find_sources();
	}
	meshes.assign(samples.size(), {});
	from_above.assign(samples.size(), Vector2());
	for (size_t level = 0; level < samples.size(); level++) {
		meshes[level].resize(samples[level].size());
		for (const std::shared_ptr<SharedMesh> &one : built[level]) {
			from_above[level] += one->from_above() / float(samples[level].size());
			width = std::max(width, one->width());
		}
	}
	samples.clear();
	find_mean();
}

// Fields that build at the same time divide their common meshes: each builds those that no other thread has started.
void SpeciesStyle::build_meshes() {
	built.assign(samples.size(), {});
	std::vector<SharedMesh *> others;
	for (size_t level = 0; level < samples.size(); level++) {
		for (const SampledPlant &sampled : samples[level]) {
			// The surfaces of a model have materials of the field.
			built[level].push_back(sampled.model ? std::make_shared<SharedMesh>(sampled) : SharedMesh::of(sampled));
			if (!built[level].back()->try_build()) {
				others.push_back(built[level].back().get());
			}
		}
	}
	for (SharedMesh *const one : others) {
		one->build();
	}
	measured.clear();
}

bool SpeciesStyle::make_meshes(double usec) {
	const Stopwatch watch;
	for (size_t level = 0; level < meshes.size(); level++) {
		for (size_t group = 0; group < meshes[level].size(); group++) {
			if (meshes[level][group].is_null()) {
				if (watch.usec() > usec) {
					return false;
				}
				meshes[level][group] = built[level][group]->make();
			}
		}
	}
	return true;
}

void SpeciesStyle::find_mean() {
	glm::vec4 sum(0.0f);
	for (const SampledPlant &sampled : nearest) {
		if (sampled.grown) {
			const FormMeasure &measure = sampled.grown->measure();
			sum += glm::vec4(measure.light, measure.translucency) / float(nearest.size());
		}
	}
	mean = Color(from_light(sum.x), from_light(sum.y), from_light(sum.z), sum.w);
}

SampledPlant SpeciesStyle::sample_alone(const PlacedPlant &plant) const {
	SampledPlant sampled = nearest[size_t(plant.variant) % nearest.size()];
	sampled.height = height_of(plant);
	sampled.has_part_bones = true;
	sampled.is_packed = false;
	sampled.cards = nullptr;
	sampled.stem = stem;
	return sampled;
}

void SpeciesStyle::take_material() {
	for (SampledPlant &sampled : nearest) {
		sampled.material = function->get_material();
	}
}

std::vector<float> SpeciesStyle::variant_heights() const {
	std::vector<float> heights;
	for (const FieldVariant &variant : variants) {
		heights.push_back(variant.height);
	}
	return heights;
}

float SpeciesStyle::mean_height() const {
	float sum = 0.0f;
	for (const FieldVariant &variant : variants) {
		sum += variant.height / float(variants.size());
	}
	return variants.empty() ? 1.0f : sum;
}

void SpeciesStyle::read_traits() {
	has_motion = true;
	motion.law = Law(int(function->get_law()));
	motion.joint = function->make_joint(Basis());
	motion.collision_radius = float(function->get_collision_radius());
	motion.trampling = function->make_trampling();
	motion.lean = std::atan2(motion.joint.rest.z, motion.joint.rest.y);
	motion.has_parts = motion.has_parts || (!samples.empty() && samples[0][0].has_parts());
	motion.shortest = motion.longest = variants.empty() ? 1.0f : variants[0].height;
	for (const FieldVariant &variant : variants) {
		motion.shortest = std::min(motion.shortest, variant.height);
		motion.longest = std::max(motion.longest, variant.height);
	}
	motion.canopy_height = 0.5f * (motion.shortest + motion.longest);
}

void SpeciesStyle::take_stem(const std::shared_ptr<const StemConstants> &found) {
	stem = found;
	motion.stem = stem ? *stem : StemConstants();
}

void SpeciesStyle::read_motion() {
	read_traits();
	take_stem(function->find_stem(mean_height(), in_air));
}

void SpeciesStyle::solve_stem() {
	if (unsolved_stem && !solved_stem.in_newtons) {
		solved_stem = shared_stem->solve(*unsolved_stem);
		take_stem(in_air ? solved_stem.in_air : solved_stem.in_newtons);
	}
}

void SpeciesStyle::send_stem() {
	if (unsolved_stem && solved_stem.in_newtons) {
		function->take_stem(*unsolved_stem, solved_stem);
	}
	unsolved_stem.reset();
	shared_stem.reset();
	solved_stem = SolvedStem();
}

float SpeciesStyle::reach_of(const PlacedPlant &plant, float widening) const {
	const float height = length_of(plant);
	const float side = width * widening * plant.scale;
	// The sides of a bent stem may be along the line to its end.
	return motion.law == Law::stem ? height + side : std::sqrt(height * height + side * side);
}

// Pages accept only finite lengths above 0. A product of extreme heights may be outside of that.
static float simulated_length(float length) {
	static constexpr float MIN_LENGTH = 1e-9f; // m.
	static constexpr float MAX_LENGTH = 1e9f;
	return length >= MIN_LENGTH ? std::min(length, MAX_LENGTH) : MIN_LENGTH;
}

MotionPlant SpeciesStyle::to_simulate(const PlacedPlant &plant) const {
	return { plant.root, simulated_length(length_of(plant)), rest_direction(plant, motion.lean), plant.scale,
		own_of_root(plant.root) };
}

void SpeciesStyle::to_simulate(const FieldPlants &plants, std::vector<MotionPlant> &into) const {
	const RestDirections rests(motion.lean);
	into.reserve(into.size() + size_t(plants.size()));
	for (int i = 0; i < plants.size(); i++) {
		const PlacedPlant plant = plants.plant(i);
		into.push_back({ plant.root, simulated_length(length_of(plant)), rests.of(plant), plant.scale,
				own_of_root(plant.root) });
	}
}

} // namespace undergrowth

#include "field/view/species_styles.hpp"

#include "base/random.hpp"
#include "base/stopwatch.hpp"
#include "form/grown_plant.hpp"
#include "placement/plant_axes.hpp"
#include "plant/base_shape.hpp"
#include "species/shared_resources.hpp"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr size_t MEASURED_VARIANTS = 3;

static int64_t variant_seed(int64_t seed, int variant) {
	return int64_t(mix_bits(uint64_t(seed) ^ mix_bits(uint64_t(variant))) >> 1);
}

int SpeciesStyle::segments_at(const FieldLevel &level) const {
	return is_by_error ? level.lod : std::clamp(int(std::lround(detail * level.lod)), MIN_LOD, MAX_LOD);
}

String SpeciesStyle::sample_next(const std::vector<FieldLevel> &given, bool by_error) {
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
		if (variant >= levels[level].groups(variant_count)) {
			break;
		}
		SampledPlant sampled;
		if (level > 0 && samples[0][size_t(variant)].grown) {
			sampled = samples[0][size_t(variant)]; // A plant of parts is the same at all levels.
			sampled.lod = segments_at(levels[level]);
		} else {
			const String problem = function->sample(0.0, segments_at(levels[level]), own_seed, sampled);
			if (!problem.is_empty()) {
				return problem;
			}
		}
		if (level == 0) {
			is_by_error = by_error && sampled.grown;
			sampled.lod = sampled.grown ? segments_at(levels[level]) : sampled.lod;
			variants.push_back({ own_seed, sampled.height });
		}
		samples[level].push_back(std::move(sampled));
	}
	return String();
}

void SpeciesStyle::load_shader() const {
	plant_shader(motion.has_parts);
}

// The largest error of some variants: a single one may lack flowers.
void SpeciesStyle::measure() {
	if (!is_by_error || samples.empty()) {
		return;
	}
	errors.assign(samples.size(), 0.0f);
	for (size_t variant = 0; variant < std::min(samples[0].size(), MEASURED_VARIANTS); variant++) {
		std::optional<LevelError> outline;
		const GrownPlant &grown = *samples[0][variant].grown;
		for (size_t level = 0; level < samples.size(); level++) {
			SampledPlant sampled = samples[0][variant];
			sampled.lod = segments_at(levels[level]);
			const float error = grown.level_error(sampled.lod, [&] {
				if (!outline) {
					outline.emplace(measure_outline(grown.form));
				}
				measured.push_back(SharedMesh::of(sampled));
				return measured.back()->outline_error(*outline);
			});
			errors[level] = std::max(errors[level], error);
		}
	}
}

// The samples of the first used level are kept for plants that get a mesh of their own.
void SpeciesStyle::leave_unused() {
	for (size_t level = 0; level < samples.size(); level++) {
		if (!levels[level].is_used) {
			samples[level].clear();
		} else if (nearest.empty()) {
			nearest = samples[level];
		}
	}
}

void SpeciesStyle::build() {
	solve_stem();
	if (samples.empty()) {
		return;
	}
	leave_unused();
	build_meshes();
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
			built[level].push_back(SharedMesh::of(sampled));
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
	sampled.stem = stem;
	return sampled;
}

void SpeciesStyle::take_material() {
	for (SampledPlant &sampled : nearest) {
		sampled.material = function->get_material();
	}
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
	motion.lean = std::atan2(motion.joint.rest.z, motion.joint.rest.y);
	motion.has_parts = motion.has_parts || (!samples.empty() && samples[0][0].grown);
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
	return { plant.root, simulated_length(length_of(plant)), rest_direction(plant, motion.lean) };
}

void SpeciesStyle::to_simulate(const FieldPlants &plants, std::vector<MotionPlant> &into) const {
	const RestDirections rests(motion.lean);
	into.reserve(into.size() + size_t(plants.size()));
	for (int i = 0; i < plants.size(); i++) {
		const PlacedPlant plant = plants.plant(i);
		into.push_back({ plant.root, simulated_length(length_of(plant)), rests.of(plant) });
	}
}

} // namespace undergrowth

// PlantFunction: samples the functions of its script or of the native species, and solves its stems.

#include "species/plant_function.hpp"

#include "base/convert.hpp"
#include "base/follow_changes.hpp"
#include "base/messages.hpp"
#include "plant/base_shape.hpp"
#include "species/script_call.hpp"
#include "species/species_sampling.hpp"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

Variant PlantFunction::call_override(
		const StringName &method, const Variant &argument, Variant::Type wanted, String &problem) {
	Array arguments;
	arguments.push_back(argument);
	return call_script_override(this, method, arguments, wanted, problem);
}

PackedVector3Array PlantFunction::own_base_shape(int lod) const {
	PackedVector3Array points;
	for (const glm::vec2 &point : circle_ring(lod)) {
		points.push_back(Vector3(point.x, 0.0f, point.y));
	}
	return points;
}

double PlantFunction::own_height(const Ref<RandomNumberGenerator> &) const {
	return 1.0;
}

double PlantFunction::own_curve_point(double offset) const {
	return 0.1 * (1.0 - offset);
}

Color PlantFunction::own_color(double) const {
	return Color(0.2f, 0.85f, 0.2f);
}

PackedVector3Array PlantFunction::call_base_shape(int lod, String &problem) {
	if (!GDVIRTUAL_IS_OVERRIDDEN(_get_base_shape)) {
		return own_base_shape(std::clamp(lod, MIN_LOD, MAX_LOD));
	}
	return call_override("_get_base_shape", lod, Variant::PACKED_VECTOR3_ARRAY, problem);
}

double PlantFunction::call_height(const Ref<RandomNumberGenerator> &rng, String &problem) {
	if (!GDVIRTUAL_IS_OVERRIDDEN(_generate_height)) {
		return own_height(rng);
	}
	return call_override("_generate_height", rng, Variant::FLOAT, problem);
}

double PlantFunction::call_curve_point(double offset, String &problem) {
	if (!GDVIRTUAL_IS_OVERRIDDEN(_calculate_curve_point)) {
		return own_curve_point(offset);
	}
	return call_override("_calculate_curve_point", offset, Variant::FLOAT, problem);
}

Color PlantFunction::call_color(double offset, String &problem) {
	if (!GDVIRTUAL_IS_OVERRIDDEN(_calculate_color_at_point)) {
		return own_color(offset);
	}
	return call_override("_calculate_color_at_point", offset, Variant::COLOR, problem);
}

bool PlantFunction::has_parts() const {
	return GDVIRTUAL_IS_OVERRIDDEN(_grow) || !arrangements.is_empty() || !has_stem;
}

bool PlantFunction::call_grow(const Ref<PlantGrowth> &plant, String &problem) {
	if (GDVIRTUAL_IS_OVERRIDDEN(_grow)) {
		call_override("_grow", plant, Variant::NIL, problem);
		return true;
	}
	if (has_stem) {
		plant->add_stem();
	}
	plant->arrange(get_arrangements());
	return false;
}

std::shared_ptr<SharedCards> PlantFunction::find_cards() {
	return get_script().get_type() == Variant::NIL ? growth.cards(*this) : nullptr;
}

PackedVector3Array PlantFunction::get_base_shape(int lod) {
	String problem;
	const PackedVector3Array shape = call_base_shape(lod, problem);
	report_fault(problem);
	return shape;
}

double PlantFunction::generate_height(const Ref<RandomNumberGenerator> &rng) {
	if (rng.is_null()) {
		report_error(this, "generate_height() needs a RandomNumberGenerator. Pass RandomNumberGenerator.new().");
		return 0.0;
	}
	String problem;
	const double height = call_height(rng, problem);
	report_fault(problem);
	return height;
}

double PlantFunction::calculate_curve_point(double offset) {
	String problem;
	const double width = call_curve_point(offset, problem);
	report_fault(problem);
	return width;
}

Color PlantFunction::calculate_color_at_point(double offset) {
	String problem;
	const Color color = call_color(offset, problem);
	report_fault(problem);
	return color;
}

void PlantFunction::report_fault(const String &problem) const {
	if (!problem.is_empty()) {
		report_error(this, problem);
	}
}

String PlantFunction::sample(double height, int segments, int64_t seed, SampledPlant &result) {
	result.options = mesh_options;
	result.options.seed = uint64_t(seed);
	result.material = material;
	result.grown.reset();
	result.model.reset();
	return sample_shape(height, segments, seed, result);
}

String PlantFunction::sample_shape(double height, int segments, int64_t seed, SampledPlant &result) {
	return has_parts() ? growth.sample(*this, height, segments, seed, result)
					   : sample_lathe(*this, height, segments, seed, result);
}

String PlantFunction::find_problem(double height, int segments, int64_t seed) {
	SampledPlant sampled;
	return sample(height, segments, seed, sampled);
}

glm::vec2 PlantFunction::resting_bend() const {
	return { 0.0f, motion.law == Law::elasticity ? 0.0f : std::tan(0.5f * motion.lean) };
}

Ref<ArrayMesh> PlantFunction::generate_mesh(double height, int segments, int64_t seed) {
	SampledPlant sampled;
	const String problem = sample(height, segments, seed, sampled);
	if (!problem.is_empty()) {
		report_error(this, problem);
		return Ref<ArrayMesh>();
	}
	return sampled.build();
}

static constexpr int STEM_SEGMENTS = 12; // Samples of a lathe's thickness along the stem.

void PlantFunction::set_stem(const Ref<PlantStem> &new_stem) {
	if (new_stem != stem) {
		const Callable listener(this, "_on_stem_changed");
		unfollow_changes(stem.ptr(), listener);
		stem = new_stem;
		follow_changes(stem.ptr(), listener);
		on_stem_changed();
	}
}

void PlantFunction::on_stem_changed() {
	reported_stem_fault = String();
	motion_changed();
}

// Samples a plant of the species' own height, so that the stem does not depend on the first request.
void PlantFunction::learn_stem(double height) {
	if (stems.has_drawn_plants()) {
		return;
	}
	follow_changes(this, Callable(this, "_on_own_change")); // A script may have other results then.
	SampledPlant plant;
	if (!sample(0.0, STEM_SEGMENTS, 0, plant).is_empty()) {
		plant = SampledPlant(); // The build of its mesh reports the fault.
		plant.height = height > 0.0 ? float(height) : 1.0f;
	}
	stems.learn(plant);
}

std::optional<UnsolvedStem> PlantFunction::describe_stem(double height) {
	if (motion.law != Law::stem) {
		return std::nullopt;
	}
	learn_stem(height);
	const UnsolvedStem unsolved = stems.unsolved_for(float(height), motion, stem);
	return stems.find(unsolved) ? std::nullopt : std::optional(unsolved);
}

void PlantFunction::take_stem(const UnsolvedStem &unsolved, const SolvedStem &found) {
	stems.take(unsolved, found);
	if (!stems.problem().is_empty() && stems.problem() != reported_stem_fault) {
		report_error(this, stems.problem() + String(" It is shown as a bare stem until then."));
		reported_stem_fault = stems.problem();
	}
}

std::shared_ptr<const StemConstants> PlantFunction::find_stem(double height, bool in_air) {
	if (motion.law != Law::stem) {
		return nullptr;
	}
	learn_stem(height);
	const UnsolvedStem unsolved = stems.unsolved_for(float(height), motion, stem);
	if (!stems.find(unsolved)) {
		take_stem(unsolved, solve_recipe(unsolved.recipe));
	}
	const SolvedStem &found = *stems.find(unsolved);
	return in_air ? found.in_air : found.in_newtons;
}

} // namespace undergrowth

// The part of PlantFunction that grows plants of parts.

#include "follow_changes.hpp"
#include "form/grown_plant.hpp"
#include "new_object.hpp"
#include "plant_function.hpp"
#include "shared_resources.hpp"
#include "stopwatch.hpp"

using namespace godot;

namespace undergrowth {

static constexpr double SLOW_GROWTH = 1.0; // s: then somebody wonders why the game stands still.
static constexpr int STEM_SEGMENTS = PartColors::ROWS - 1; // Its functions are asked at so many offsets and one more.

bool PlantFunction::has_parts() const {
	return GDVIRTUAL_IS_OVERRIDDEN(_grow) || !arrangements.is_empty() || !has_stem;
}

String PlantFunction::read_stem(Part &into) {
	SampledPlant sampled;
	String problem = sample_ring(STEM_SEGMENTS, sampled);
	if (problem.is_empty()) {
		problem = sample_profile(sampled);
	}
	if (!problem.is_empty()) {
		return problem;
	}
	into.kind = PartKind::axis;
	into.width = 2.0f * sampled.cross_section.radius;
	into.axis.tip_diameter = into.width;
	into.axis.ring = sampled.cross_section.points;
	into.widths.samples = sampled.widths;
	into.frequency = 0.0f;
	for (const glm::vec4 &color : sampled.colors) {
		into.colors.samples.insert(into.colors.samples.end(), PartColors::COLUMNS, color);
	}
	return String::utf8(find_part_fault(into).c_str());
}

// Once for each seed as long as the species stays the same; level and height do not matter.
String PlantFunction::sample_parts(double height, int64_t seed, SampledPlant &result) {
	result.grown = grown_before.find(seed, state_of_script(this));
	if (!result.grown) {
		const String problem = grow(seed, result.grown);
		if (!problem.is_empty()) {
			return problem;
		}
	}
	parts_material(); // Loaded here, for meshes may be built on worker threads.
	result.height = height == 0.0 ? result.grown->form.height : float(height);
	return height == 0.0 ? String() : find_height_problem(height);
}

String PlantFunction::grow(int64_t seed, std::shared_ptr<const GrownPlant> &grown) {
	SampledPlant sampled;
	String problem = sample_height(0.0, seed, sampled);
	if (!problem.is_empty()) {
		return problem;
	}
	// Whom it listens to it hears from the first growth on: scripts tell of no change of their variables' insides.
	follow_changes(this, Callable(this, "_on_own_change"));
	follow_script_resources(this, Callable(this, "_on_grown_change"));
	Ref<PlantGrowth> plant;
	plant.instantiate();
	plant->begin(this, sampled.height, uint64_t(seed));
	ask_grow(plant, problem);
	String what;
	PlantForm form = plant->finish(what);
	problem = problem.is_empty() ? what : problem;
	if (problem.is_empty()) {
		grown = std::make_shared<const GrownPlant>(std::move(form));
		grown_before.keep(seed, state_of_script(this), grown);
	}
	return problem;
}

void PlantFunction::ask_grow(const Ref<PlantGrowth> &plant, String &problem) {
	if (!GDVIRTUAL_IS_OVERRIDDEN(_grow)) {
		if (has_stem) {
			plant->add_stem();
		}
		plant->arrange(get_arrangements());
		return;
	}
	const Stopwatch watch;
	call_override("_grow", plant, Variant::NIL, problem);
	const double seconds = 1e-6 * watch.usec();
	if (seconds > SLOW_GROWTH && !has_told_slowness) {
		has_told_slowness = true;
		report_warning(this,
				"its `_grow` took " + String::num(seconds, 1) +
						" s for one plant, while the game stood still. Let it do less: what is the same for all seeds "
						"can be worked out once, and a field asks for as many plants as the species has variants.");
	}
}

// How it moves and what it wears leaves what has grown as it is.
void PlantFunction::on_own_change() {
	if (!is_motion_change() && !is_material_change()) {
		grown_before.clear();
	}
}

void PlantFunction::on_grown_change() {
	grown_before.clear();
}

void PlantFunction::on_arrangement_changed() {
	shape_changed();
}

void PlantFunction::set_has_stem(bool grows) {
	if (grows != has_stem) {
		has_stem = grows;
		shape_changed();
	}
}

void PlantFunction::set_arrangements(const TypedArray<PlantArrangement> &list) {
	const Callable changed(this, "_on_arrangement_changed");
	for (int64_t i = 0; i < arrangements.size(); i++) {
		unfollow_changes(Ref<PlantArrangement>(arrangements[i]).ptr(), changed);
	}
	const bool is_same = arrangements == list;
	arrangements = list.duplicate();
	for (int64_t i = 0; i < arrangements.size(); i++) {
		follow_changes(Ref<PlantArrangement>(arrangements[i]).ptr(), changed);
	}
	if (!is_same) {
		shape_changed();
	}
}

TypedArray<PlantArrangement> PlantFunction::get_arrangements() const {
	return TypedArray<PlantArrangement>(arrangements);
}

} // namespace undergrowth

// The part of PlantFunction that grows plants of parts.

#include "follow_changes.hpp"
#include "form/grown_plant.hpp"
#include "new_object.hpp"
#include "plant_function.hpp"
#include "shared_resources.hpp"

using namespace godot;

namespace undergrowth {

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

// Once for each seed; the level does not matter.
String PlantFunction::grow(double height, int64_t seed, SampledPlant &result) {
	String problem = sample_height(0.0, seed, result);
	if (!problem.is_empty()) {
		return problem;
	}
	Ref<PlantGrowth> plant;
	plant.instantiate();
	plant->begin(this, result.height, uint64_t(seed));
	if (GDVIRTUAL_IS_OVERRIDDEN(_grow)) {
		call_override("_grow", plant, Variant::NIL, problem);
	} else {
		if (has_stem) {
			plant->add_stem();
		}
		plant->arrange(get_arrangements());
	}
	String what;
	PlantForm form = plant->finish(what);
	problem = problem.is_empty() ? what : problem;
	if (!problem.is_empty()) {
		return problem;
	}
	auto grown = std::make_shared<GrownPlant>();
	grown->form = std::move(form);
	grown->measure = measure_form(grown->form);
	grown->bones = FormBones(grown->form, hang_parts(grown->form));
	result.grown = grown;
	parts_material(); // Loaded here, for meshes may be built on worker threads.
	result.height = height == 0.0 ? grown->form.height : float(height);
	return height == 0.0 ? problem : find_height_problem(height);
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

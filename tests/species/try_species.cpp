#include "try_species.hpp"

#include "any_plant.hpp"
#include "drawn_form.hpp"

#include "motion/part_bend.hpp"

#include <glm/geometric.hpp>

using namespace undergrowth;

namespace {

constexpr int MAX_SEGMENTS = 16;
constexpr int BENDS = 3;

bool are_finite(const glm::vec3 &v) {
	return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::string look_at_form(const PlantForm &form) {
	for (const PlacedPart &part : form.placed) {
		if (!are_finite(part.base) || !are_finite(part.axes.x) || !are_finite(part.axes.along) ||
				!are_finite(part.axes.outward) || !std::isfinite(part.length + part.width + part.tint)) {
			return "a part has numbers that are not finite";
		}
		if (!(part.rank >= 0.0f && part.rank < 1.0f) || !(part.offset >= 0.0f && part.offset <= 1.0f) ||
				part.carrier >= &part - form.placed.data()) {
			return "a part has no place";
		}
	}
	const bool is_sound = std::isfinite(form.height) && form.height > 0.0f && std::isfinite(form.reach) &&
			form.placed.size() <= static_cast<size_t>(MAX_PARTS);
	return is_sound ? std::string() : "the plant has no size, or too many parts";
}

std::string look_at_measure(const FormMeasure &measure) {
	float sum = measure.light.x + measure.light.y + measure.light.z;
	for (const float shown : measure.shown) {
		sum += shown;
	}
	for (const float outline : measure.outlines) {
		sum += outline;
	}
	return std::isfinite(sum) ? std::string() : "what is measured is not finite";
}

glm::vec2 any_bend(Chance &chance, float max) {
	const float size = chance.one_in(6) ? 0.0f : chance.spread(1e-6f, max);
	return { size * chance.within(-1.0f, 1.0f), size * chance.within(-1.0f, 1.0f) };
}

std::string bend_bones(const FormBones &bones, Chance &chance) {
	StemMotion stem;
	const float max = chance.one_in(4) ? 1e15f : 3.0f;
	stem.bend = any_bend(chance, max);
	stem.rate = any_bend(chance, 10.0f * max);
	stem.rest = any_bend(chance, 2.0f);
	stem.clock = chance.within(0.0f, 1.0f);
	for (const PartBone &bone : bones.stretched(chance.spread(0.1f, 10.0f))) {
		if (!are_finite(bone.pivot) || !are_finite(bone.origin)) {
			return "a bone's place is not finite";
		}
		const glm::vec2 bend = part_bend(bone.swing, stem);
		if (!(glm::length(bend) <= 1.0001f * MAX_PART_BEND)) {
			return "a part's bend is not finite, or too far";
		}
		const PartPose pose = pose_of(bone, stem);
		const bool is_unit = std::abs(glm::dot(pose.turn, pose.turn) - 1.0f) < 1e-3f;
		if (!is_unit || !std::isfinite(pose.size) || !are_finite(pose.shift)) {
			return "a bone's pose is not finite";
		}
	}
	return {};
}

} // namespace

std::string try_species(uint64_t seed, Stage &stage, bool &is_grown) {
	Chance chance(seed);
	stage = "growing";
	PlantForm form;
	is_grown = grow_any_plant(chance, seed, form);
	if (!is_grown) {
		return {};
	}
	std::string problem = look_at_form(form);
	if (!problem.empty()) {
		return problem;
	}
	stage = "being measured";
	const FormMeasure measure = measure_form(form);
	problem = look_at_measure(measure);
	const FormBones bones(form, attach_parts(form));
	for (int i = 0; i < BENDS && problem.empty(); i++) {
		problem = bend_bones(bones, chance);
	}
	if (!problem.empty()) {
		return problem;
	}
	const int segments = chance.whole(1, MAX_SEGMENTS);
	const std::string level = " at " + std::to_string(segments) + " segments";
	stage = "being planned";
	const FormPlan plan = plan_form(form, measure, vertex_budget(segments));
	if (plan.counts.vertices > vertex_budget(segments)) {
		return std::to_string(plan.counts.vertices) + " vertices, more than its budget," + level;
	}
	stage = "being drawn";
	MeshOptions options;
	options.color_deviation = chance.within(0.0f, 1.0f);
	options.seed = seed;
	const float height = form.height * (chance.one_in(3) ? 1.0f : chance.spread(0.1f, 10.0f));
	problem = DrawnForm(form, measure, plan, bones, options, height).problem();
	return problem.empty() ? problem : problem + level;
}

#include "mesh/form_plan.hpp"

#include "mesh/plan_steps.hpp"

#include <algorithm>

namespace undergrowth {

int vertex_budget(int lod) {
	return std::max(12, (11 * lod * lod + 1) / 2);
}

MeshCounts count_body(const PartGroup &group, const BodyDetail &detail) {
	const int rings = group.layout == Layout::whorl ? detail.rings : 1;
	if (detail.is_rod) {
		return { 2 * detail.sides, 6 * detail.sides };
	}
	const bool is_cap = group.layout == Layout::whorl || (group.layout == Layout::disc && group.dome <= HALF_SPHERE);
	const int poles = is_cap ? 1 : 2;
	return { detail.sides * rings + poles, 3 * detail.sides * (2 * (rings - 1) + poles) };
}

FormPlan plan_form(const PlantForm &form, const FormMeasure &measure, int budget, const CarriedCards &cards) {
	PlanSteps steps(form, measure, budget, cards);
	bool is_cut = false;
	while (steps.vertices() > budget && steps.take_best(budget)) {
		is_cut = true;
	}
	while (is_cut && steps.give_back(budget)) {
	}
	FormPlan plan = steps.finish();
	plan.is_cut = is_cut;
	return plan;
}

bool has_open_bodies(const PlantForm &form, const FormPlan &plan) {
	for (size_t i = 0; i < form.placed.size(); i++) {
		const size_t group = static_cast<size_t>(form.placed[i].group);
		if (plan.fates[i] == FormPlan::merged && plan.groups[group].body.sides > 0 &&
				form.groups[group].layout != Layout::disc) {
			return true;
		}
	}
	return false;
}

void divide_carriers(const PlantForm &form, int rows, FormPlan &plan) {
	std::vector<bool> carries(form.groups.size(), false);
	for (size_t i = 0; i < form.placed.size(); i++) {
		const int carrier = form.placed[i].carrier;
		if (carrier != ON_GROUND && plan.fates[i] != FormPlan::dropped &&
				form.placed[static_cast<size_t>(carrier)].carrier == ON_GROUND) {
			carries[static_cast<size_t>(form.placed[static_cast<size_t>(carrier)].group)] = true;
		}
	}
	for (size_t g = 0; g < form.groups.size(); g++) {
		const PartGroup &group = form.groups[g];
		const Part &part = form.parts[static_cast<size_t>(group.kind)];
		PartDetail &detail = plan.groups[g].detail;
		if (!carries[g] || part.kind == PartKind::bead || detail.rows >= rows) {
			continue;
		}
		const MeshCounts before = count_part(part, detail);
		detail.rows = rows;
		const MeshCounts now = count_part(part, detail);
		for (int i = group.first; i < group.first + group.count; i++) {
			if (plan.fates[static_cast<size_t>(i)] == FormPlan::drawn) {
				plan.counts.vertices += now.vertices - before.vertices;
				plan.counts.indices += now.indices - before.indices;
			}
		}
	}
}

} // namespace undergrowth

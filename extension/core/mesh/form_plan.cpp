#include "mesh/form_plan.hpp"

#include "mesh/plan_steps.hpp"

#include <algorithm>

namespace undergrowth {

int vertex_budget(int lod) {
	return std::max(12, (11 * lod * lod + 1) / 2);
}

MeshCounts count_body(const PartGroup &group, const BodyDetail &detail) {
	const int rings = group.layout == Layout::whorl ? detail.rings : 1;
	const bool is_cap = group.layout == Layout::whorl || (group.layout == Layout::disc && group.dome <= HALF_SPHERE);
	const int poles = is_cap ? 1 : 2;
	return { detail.sides * rings + poles, 3 * detail.sides * (2 * (rings - 1) + poles) };
}

FormPlan plan_form(const PlantForm &form, const FormMeasure &measure, int budget) {
	PlanSteps steps(form, measure, budget > vertex_budget(FINEST_USUAL_LOD));
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

} // namespace undergrowth

#include "mesh/plan_steps.hpp"

#include "conventions.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace undergrowth {

namespace {

constexpr float CONTRAST_WEIGHT = 6.0f; // Times the squared distance of the colours.

/// Returns the fraction of a group's body that its parts fill.
float cover_of(const PartGroup &group, const Part &part) {
	if (group.layout == Layout::disc) {
		return 1.0f;
	}
	if (group.layout != Layout::whorl) {
		return group.is_rod ? 0.7f : 0.4f;
	}
	const float around = 2.0f * static_cast<float>(PI) * (group.radius + 0.5f * part.mean_length());
	return std::min(1.0f, static_cast<float>(group.count) * part.width / around);
}

} // namespace

float worth_of(const glm::vec3 &color, const glm::vec3 &mean) {
	const glm::vec3 way = color - mean;
	return 1.0f + CONTRAST_WEIGHT * glm::dot(way, way);
}

PlanSteps::PlanSteps(const PlantForm &p_form, const FormMeasure &p_measure, int budget, const CarriedCards &p_cards) :
		form(p_form), measure(p_measure), cards(p_cards), states(p_form.groups.size()) {
	const bool is_close = budget > vertex_budget(FINEST_USUAL_LOD);
	for (size_t g = 0; g < states.size(); g++) {
		const Part &part = form.parts[static_cast<size_t>(form.groups[g].kind)];
		State &state = states[g];
		state.details = details_of(part, is_close);
		for (const PartDetail &detail : state.details) {
			state.costs.push_back(count_part(part, detail).vertices);
			state.errors.push_back(error_of(part, detail));
		}
		state.cover = cover_of(form.groups[g], part);
		count_left(g);
		state.area = measure.shown[g];
		const int carrier = form.groups[g].carrier_group;
		if (carrier != ON_GROUND && form.groups[static_cast<size_t>(carrier)].depth == 1) {
			states[static_cast<size_t>(carrier)].is_stem = true;
		}
	}
	find_cards();
	find_relatives();
	find_contrasts();
	find_worths();
	recount();
}

/// Counts the parts of a group that each entry of DENSITIES leaves.
void PlanSteps::count_left(size_t group) {
	const PartGroup &own = form.groups[group];
	states[group].left.assign(DENSITY_COUNT, 0);
	for (int i = own.first; i < own.first + own.count; i++) {
		for (size_t density = 0; density < DENSITY_COUNT; density++) {
			states[group].left[density] += form.placed[static_cast<size_t>(i)].rank < DENSITIES[density] ? 1 : 0;
		}
	}
}

/// Groups are after those of their carriers.
void PlanSteps::find_cards() {
	for (size_t g = states.size(); g-- > 0 && !cards.is_empty();) {
		State &state = states[g];
		state.card_area = cards.areas[g];
		state.carries_cards = state.carries_cards || state.card_area > 0.0f;
		state.is_stem = state.is_stem || (state.card_area > 0.0f && form.groups[g].depth == 1);
		const int carrier = form.groups[g].carrier_group;
		if (carrier != ON_GROUND && state.carries_cards) {
			states[static_cast<size_t>(carrier)].carries_cards = true;
		}
	}
}

/// Computed once, because plants may have as many groups as parts.
void PlanSteps::find_relatives() {
	std::map<std::pair<int, int>, size_t> known;
	for (size_t g = 0; g < states.size(); g++) {
		const PartGroup &group = form.groups[g];
		if (group.carrier_group != ON_GROUND) {
			states[static_cast<size_t>(group.carrier_group)].carried.push_back(g);
		}
		states[g].twins = known.emplace(std::pair(group.kind, group.carrier_group), known.size()).first->second;
	}
	twins.resize(known.size());
}

void PlanSteps::find_contrasts() {
	for (size_t g = 0; g < states.size(); g++) {
		const glm::vec4 &own = measure.colors[static_cast<size_t>(form.groups[g].kind)];
		float nearest = 1.0f;
		for (const PartGroup &other : form.groups) {
			const glm::vec4 way = measure.colors[static_cast<size_t>(other.kind)] - own;
			nearest = other.kind == form.groups[g].kind ? nearest : std::min(nearest, glm::dot(way, way));
		}
		states[g].contrast = nearest;
	}
}

void PlanSteps::find_worths() {
	glm::vec4 mean(0.0f);
	float whole = 1e-12f;
	for (size_t g = 0; g < states.size(); g++) {
		mean += measure.colors[static_cast<size_t>(form.groups[g].kind)] * states[g].area;
		mean += cards.is_empty() ? glm::vec4(0.0f) : cards.colors[g] * states[g].card_area;
		whole += states[g].area + states[g].card_area;
	}
	mean /= whole;
	for (size_t g = 0; g < states.size(); g++) {
		states[g].worth =
				worth_of(glm::vec3(measure.colors[static_cast<size_t>(form.groups[g].kind)]), glm::vec3(mean));
		states[g].area *= states[g].worth;
		states[g].card_area *= cards.is_empty() ? 1.0f : worth_of(glm::vec3(cards.colors[g]), glm::vec3(mean));
	}
}

void PlanSteps::recount() {
	fates.assign(form.placed.size(), FormPlan::drawn);
	bodies.assign(form.placed.size(), -1);
	body_count = 0;
	for (State &state : states) {
		state.parts = state.bodies = state.card_vertices = 0;
	}
	for (size_t i = 0; i < form.placed.size(); i++) {
		const PlacedPart &part = form.placed[i];
		State &state = states[static_cast<size_t>(part.group)];
		const size_t carrier = static_cast<size_t>(std::max(part.carrier, 0));
		const FormPlan::Fate fate = part.carrier == ON_GROUND ? FormPlan::drawn : fates[carrier];
		if (fate == FormPlan::dropped || (fate == FormPlan::drawn && !(part.rank < DENSITIES[state.density]))) {
			fates[i] = FormPlan::dropped;
		} else if (fate == FormPlan::merged) {
			fates[i] = FormPlan::merged;
			bodies[i] = bodies[carrier];
		} else if (state.body > 0) {
			// Parts of one carrier are consecutive.
			const bool goes_on = i > 0 && form.placed[i - 1].group == part.group &&
					form.placed[i - 1].carrier == part.carrier && bodies[i - 1] >= 0;
			fates[i] = FormPlan::merged;
			bodies[i] = goes_on ? bodies[i - 1] : body_count++;
			state.bodies += goes_on ? 0 : 1;
		} else {
			state.parts++;
			state.card_vertices += cards.is_empty() ? 0 : cards.vertices[i];
		}
	}
	add_up_branches();
}

BodyDetail PlanSteps::body_of(size_t group, size_t body) const {
	BodyDetail detail = BODIES[body];
	detail.is_rod = body > 0 && form.groups[group].is_rod;
	return detail;
}

int PlanSteps::own_vertices(size_t group) const {
	const State &state = states[group];
	return state.parts * state.costs[state.detail] + state.card_vertices +
			state.bodies * count_body(form.groups[group], body_of(group, state.body)).vertices;
}

void PlanSteps::add_up_branches() {
	total = 0;
	evaluated += static_cast<int64_t>(form.placed.size() + states.size());
	twins.assign(twins.size(), {});
	for (size_t g = states.size(); g-- > 0;) {
		State &state = states[g];
		state.branch_vertices = own_vertices(g);
		total += state.branch_vertices;
		twins[state.twins].drawn += state.branch_vertices > 0 ? 1 : 0;
		twins[state.twins].dropped_area += state.branch_vertices > 0 ? 0.0f : state.area;
	}
	for (size_t g = states.size(); g-- > 0;) {
		State &state = states[g];
		state.branch_area = state.area + state.card_area;
		state.branch_error = own_error(state);
		for (const size_t other : state.carried) {
			state.branch_vertices += states[other].branch_vertices;
			state.branch_area += states[other].branch_area;
			state.branch_error += states[other].branch_error;
		}
	}
}

/// Returns the number of parts of a group that would be drawn as parts with this fraction.
int PlanSteps::count_drawn(size_t group, float density) const {
	const PartGroup &own = form.groups[group];
	int count = 0;
	for (size_t i = static_cast<size_t>(own.first); i < static_cast<size_t>(own.first + own.count); i++) {
		const PlacedPart &part = form.placed[i];
		const bool is_supported =
				part.carrier == ON_GROUND || fates[static_cast<size_t>(part.carrier)] == FormPlan::drawn;
		count += is_supported && part.rank < density ? 1 : 0;
	}
	return count;
}

/// True if undoing a step, to `next`, may fit into this many vertices. For carriers only a trial shows it.
bool PlanSteps::could_fit(size_t group, const Drawn &next, int room) const {
	const State &state = states[group];
	if (!state.carried.empty() || state.card_area > 0.0f || (state.body == 0) != (next.body == 0)) {
		return true;
	}
	const int bodies_now = state.bodies * count_body(form.groups[group], body_of(group, state.body)).vertices;
	const int finer = next.body > 0 ? state.bodies * count_body(form.groups[group], body_of(group, next.body)).vertices
									: count_drawn(group, DENSITIES[next.density]) * state.costs[next.detail];
	return finer - (next.body > 0 ? bodies_now : state.parts * state.costs[state.detail]) <= room;
}

bool PlanSteps::give_back(int budget) {
	struct Gain {
		float gain;
		size_t group;
		Drawn drawn;
	};
	std::vector<Gain> gains;
	for (size_t g = 0; g < states.size(); g++) {
		const Drawn before = states[g];
		const float error = own_error(states[g]);
		const bool is_finer = step_back(states[g]);
		const Gain gain = { error - own_error(states[g]), g, states[g] };
		draw(g, before);
		if (is_finer && gain.gain > 0.0f && could_fit(g, gain.drawn, budget - total)) {
			gains.push_back(gain);
		}
	}
	std::stable_sort(gains.begin(), gains.end(), [](const Gain &a, const Gain &b) { return a.gain > b.gain; });
	for (const Gain &best : gains) {
		const Drawn before = states[best.group];
		draw(best.group, best.drawn);
		recount();
		if (total <= budget) {
			return true;
		}
		draw(best.group, before);
	}
	recount();
	return false;
}

/// One step finer: all parts before finer parts.
bool PlanSteps::step_back(State &state) const {
	if (DENSITIES[state.density] == 0.0f) { // A body replaces all parts.
		state.density = state.body > 0 ? 0 : state.density - 1;
	} else if (state.body == 0 && state.parts == 0) {
		return false;
	} else if (state.body > 1) {
		state.body--;
	} else if (state.body == 1) {
		return false; // Drawing parts again would exceed the budget.
	} else if (state.density > 0) {
		state.density--;
	} else if (state.detail > 0) {
		state.detail--;
	} else {
		return false;
	}
	return true;
}

/// Distributes the area of groups that are not drawn: to groups of the same kind, else of the nearest colour. Leaves
/// are preferred to stems, which would become posts.
void PlanSteps::pass_on(std::vector<float> &shown) const {
	for (size_t g = 0; g < states.size(); g++) {
		const int kind = form.groups[g].kind;
		const bool in_body = fates[static_cast<size_t>(form.groups[g].first)] == FormPlan::merged;
		if (own_vertices(g) > 0 || in_body || shown[g] == 0.0f) {
			continue;
		}
		size_t heir = g;
		float min = 1e9f;
		for (size_t other = 0; other < states.size(); other++) {
			const glm::vec4 way = measure.colors[static_cast<size_t>(form.groups[other].kind)] -
					measure.colors[static_cast<size_t>(kind)];
			const float distance = form.groups[other].kind == kind
					? -1.0f
					: glm::dot(way, way) + (states[other].is_stem ? 0.05f : 0.0f);
			if (own_vertices(other) > 0 && distance < min) {
				heir = other;
				min = distance;
			}
		}
		shown[heir] += heir == g ? 0.0f : shown[g];
		shown[g] = 0.0f;
	}
}

FormPlan PlanSteps::finish() {
	FormPlan plan;
	plan.shown = measure.shown;
	pass_on(plan.shown);
	for (size_t g = 0; g < states.size(); g++) {
		const State &state = states[g];
		const PartDetail &detail = state.details[state.detail];
		plan.groups.push_back({ detail, DENSITIES[state.density], body_of(g, state.body) });
		const MeshCounts part = count_part(form.parts[static_cast<size_t>(form.groups[g].kind)], detail);
		plan.counts.vertices += own_vertices(g) - state.card_vertices;
		plan.counts.indices +=
				state.parts * part.indices + state.bodies * count_body(form.groups[g], body_of(g, state.body)).indices;
	}
	plan.fates = std::move(fates);
	plan.bodies = std::move(bodies);
	plan.body_count = body_count;
	return plan;
}

} // namespace undergrowth

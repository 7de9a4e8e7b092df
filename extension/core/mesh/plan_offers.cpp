// PlanSteps: the savings and the harm of each step.

#include "mesh/plan_steps.hpp"

#include <algorithm>
#include <vector>

namespace undergrowth {

namespace {

// Harm of steps to a picture, as fractions of the affected area: estimates for ordering the steps, not physics.
constexpr float THINNED = 0.1f; // Times the number of replaced parts per remaining part.
constexpr float ONE_SIDED = 0.6f; // Divided by the number of remaining parts: fewer are more asymmetric.
constexpr float THINNED_TUFT = 0.06f; // Additional harm: a few wide leaves do not look like many narrow ones.
constexpr float MAX_TUFT = 0.06f; // Its limit, because a plant without flowers also looks different.
constexpr float TWIN_DROPPED = 0.2f; // If another group of the same kind remains on the same carriers.
constexpr float DROPPED = 1.3f;
constexpr float MAX_THINNING = 0.6f; // A few parts are better than none.
constexpr float COLOR_LOST = 30.0f; // Times the squared distance to the nearest remaining colour.
constexpr float THINNED_WHORL = 0.3f; // One side of a flower does not look like a flower.
constexpr float MERGED = 0.08f;
constexpr float UNCOVERED = 0.35f; // For the fraction of a body that its parts leave open.
constexpr float BODY_SIDE = 0.3f; // Divided by the squared number of sides.
constexpr float FLOWER_WORTH = 1.5f; // From here on, the colour is that of a flower.
constexpr float CONE = 0.05f; // For the lathe of a whorl.
constexpr int MAX_BODIES_LEFT = 2; // Limits cycles of bodies and few parts; all other steps only reduce detail.
constexpr size_t MANY_GROUPS = 48; // Only scripts that add parts in loops have more.
constexpr float NEARLY = 1.25f; // Times the best price.

float body_error(const PartGroup &group, const BodyDetail &detail) {
	const float cone = group.layout == Layout::whorl && detail.rings == 1 ? CONE : 0.0f;
	return cone + BODY_SIDE / static_cast<float>(detail.sides * detail.sides);
}

} // namespace

float PlanSteps::thin_error(const State &state, size_t density) const {
	const size_t group = static_cast<size_t>(&state - states.data());
	if (DENSITIES[density] > 0.0f) {
		const bool is_whorl = form.groups[group].layout == Layout::whorl;
		const float left = static_cast<float>(state.left[density]);
		const float thinned = static_cast<float>(state.left[0]) / left - 1.0f;
		const bool is_tuft = form.groups[group].layout == Layout::ground;
		const float tuft = is_tuft ? std::min(THINNED_TUFT * thinned, MAX_TUFT) : 0.0f;
		const float others = std::min((is_whorl ? THINNED_WHORL : THINNED) * thinned + tuft, MAX_THINNING);
		return thinned <= 0.0f ? 0.0f : others + ONE_SIDED / left;
	}
	return has_twin(static_cast<int>(group)) ? TWIN_DROPPED : DROPPED + COLOR_LOST * state.contrast;
}

/// True if another twin is drawn.
bool PlanSteps::has_twin(int group) const {
	const size_t own = static_cast<size_t>(group);
	return twins[states[own].twins].drawn > (own_vertices(own) > 0 ? 1 : 0);
}

/// Returns the area that disappears with a group. The last drawn twin counts for all its twins.
float PlanSteps::dropped_area(const State &state) const {
	const size_t group = static_cast<size_t>(&state - states.data());
	return state.branch_area + twins[state.twins].dropped_area - (own_vertices(group) > 0 ? 0.0f : state.area);
}

float PlanSteps::own_error(const State &state) const {
	const float flat = state.is_stem && state.details[state.detail].columns == 2 ? FLAT_STEM : 0.0f;
	return state.area * (state.errors[state.detail] + flat) +
			(state.area + state.card_area) * thin_error(state, state.density);
}

void PlanSteps::offer(
		Step &best, int group, size_t detail, size_t density, size_t body, float saved, float harm) const {
	if (saved < 0.5f) {
		return;
	}
	const float price = harm / saved;
	if (best.group < 0 || price < best.price) {
		best.group = group;
		best.price = price;
		best.saved = saved;
		best.next.detail = detail;
		best.next.density = density;
		best.next.body = body;
	}
}

void PlanSteps::offer_details(Step &best, int group, int excess) const {
	const State &state = states[static_cast<size_t>(group)];
	for (size_t detail = state.detail + 1; detail < state.details.size() && state.parts > 0; detail++) {
		const int saved = state.parts * (state.costs[state.detail] - state.costs[detail]);
		const bool turns_flat =
				state.is_stem && state.details[detail].columns == 2 && state.details[state.detail].columns > 2;
		const float harm =
				state.area * (state.errors[detail] - state.errors[state.detail] + (turns_flat ? FLAT_STEM : 0.0f));
		offer(best, group, detail, state.density, state.body, static_cast<float>(std::min(saved, excess)), harm);
	}
}

void PlanSteps::offer_thinning(Step &best, int group, int excess) const {
	const State &state = states[static_cast<size_t>(group)];
	for (size_t density = state.density + 1; density < state.density_end && DENSITIES[state.density] > 0.0f;
			density++) {
		if (state.body > 0 && DENSITIES[density] > 0.0f) {
			offer_few(best, group, density, excess); // A body replaces all of its parts.
			continue;
		}
		if (DENSITIES[density] == 0.0f && state.branch_vertices == total) {
			continue; // Every plant needs something visible.
		}
		const float left = static_cast<float>(state.left[density]) / static_cast<float>(state.left[state.density]);
		const float saved = static_cast<float>(state.branch_vertices) * (1.0f - left);
		const float area = DENSITIES[density] == 0.0f ? dropped_area(state) : state.branch_area;
		const float harm = area * (thin_error(state, density) - thin_error(state, state.density));
		offer(best, group, state.detail, density, state.body, std::min(saved, static_cast<float>(excess)), harm);
	}
}

/// Offers a few parts of the lowest detail instead of a body.
void PlanSteps::offer_few(Step &best, int group, size_t density, int excess) const {
	const State &state = states[static_cast<size_t>(group)];
	const PartGroup &own = form.groups[static_cast<size_t>(group)];
	const bool carries = state.branch_area > state.area;
	const bool is_flower = state.worth > FLOWER_WORTH;
	if (state.bodies_left >= MAX_BODIES_LEFT) {
		return;
	}
	if (carries || is_flower || own.layout == Layout::disc || own.layout == Layout::whorl || state.bodies == 0) {
		return; // A carrier is more than its parts, and flowers stay whole.
	}
	const int saved = state.branch_vertices - state.left[density] * state.costs.back();
	const float harm = state.area *
			(thin_error(state, density) + state.errors.back() - body_error(own, BODIES[state.body]) - MERGED -
					UNCOVERED * (1.0f - state.cover));
	offer(best, group, state.details.size() - 1, density, 0, static_cast<float>(std::min(saved, excess)),
			std::max(harm, 0.0f));
}

void PlanSteps::offer_body(Step &best, int group, int excess) const {
	const State &state = states[static_cast<size_t>(group)];
	const PartGroup &own = form.groups[static_cast<size_t>(group)];
	if (own.carrier_group == ON_GROUND || own.count < 2 || state.carries_cards) {
		return; // A tuft is not a lump, a single part stays a part, and bodies carry no cards.
	}
	const int carriers =
			state.body > 0 ? state.bodies : std::max(1, states[static_cast<size_t>(own.carrier_group)].parts);
	for (size_t body = state.body + 1; body < BODY_COUNT; body++) {
		const int saved =
				state.branch_vertices - carriers * count_body(own, body_of(static_cast<size_t>(group), body)).vertices;
		const float harm = state.body > 0
				? state.branch_area * (body_error(own, BODIES[body]) - body_error(own, BODIES[state.body]))
				: state.branch_area * (body_error(own, BODIES[body]) + MERGED + UNCOVERED * (1.0f - state.cover)) -
						state.branch_error;
		offer(best, group, state.detail, 0, body, static_cast<float>(std::min(saved, excess)), std::max(harm, 0.0f));
	}
}

/// Returns the best step of one group.
PlanSteps::Step PlanSteps::find_best(int group, int excess) const {
	Step best;
	if (states[static_cast<size_t>(group)].branch_vertices > 0) {
		offer_details(best, group, excess);
		offer_thinning(best, group, excess);
		offer_body(best, group, excess);
	}
	return best;
}

void PlanSteps::take(const Step &step) {
	State &state = states[static_cast<size_t>(step.group)];
	state.bodies_left += state.body > 0 && step.next.body == 0 ? 1 : 0;
	draw(static_cast<size_t>(step.group), step.next);
}

/// Also takes the steps that cost nearly as little as the best one, until the budget is met. Drops at most every second
/// twin, because the last one counts for all.
void PlanSteps::take_many(std::vector<Step> &steps, const Step &best, int excess) {
	std::stable_sort(steps.begin(), steps.end(), [](const Step &a, const Step &b) { return a.price < b.price; });
	const std::vector<Drawn> before(states.begin(), states.end());
	float left = static_cast<float>(excess) - best.saved;
	std::vector<int> dropped(twins.size(), 0);
	for (const Step &step : steps) {
		const State &state = states[static_cast<size_t>(step.group)];
		const bool drops = DENSITIES[step.next.density] == 0.0f && step.next.body == 0;
		const int drawn = twins[state.twins].drawn;
		if (step.price > NEARLY * best.price || left <= 0.0f) {
			break;
		}
		if (step.group == best.group || (drops && drawn > 1 && 2 * (dropped[state.twins] + 1) >= drawn)) {
			continue;
		}
		dropped[state.twins] += drops ? 1 : 0;
		left -= step.saved;
		take(step);
	}
	recount();
	if (total == 0) { // The dropped groups may carry everything.
		for (size_t g = 0; g < states.size(); g++) {
			draw(g, before[g]);
		}
		recount();
	}
}

bool PlanSteps::take_best(int budget) {
	const int excess = total - budget;
	for (size_t tries = 0; tries <= DENSITY_COUNT * states.size(); tries++) {
		Step best;
		std::vector<Step> steps;
		evaluated += static_cast<int64_t>(states.size());
		for (int group = 0; group < static_cast<int>(states.size()); group++) {
			const Step step = find_best(group, excess);
			if (step.group >= 0 && (best.group < 0 || step.price < best.price)) {
				best = step;
			}
			if (step.group >= 0 && states.size() > MANY_GROUPS) {
				steps.push_back(step);
			}
		}
		if (best.group < 0) {
			return false;
		}
		const Drawn before = states[static_cast<size_t>(best.group)];
		take(best);
		recount();
		if (total > 0) {
			if (steps.size() > MANY_GROUPS && total > budget) {
				take_many(steps, best, excess);
			}
			return true;
		}
		// Parts of several groups may carry other parts together; dropping one group may then remove everything.
		states[static_cast<size_t>(best.group)].density_end = best.next.density;
		draw(static_cast<size_t>(best.group), before);
		recount();
	}
	return false;
}

} // namespace undergrowth

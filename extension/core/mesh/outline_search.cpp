// OutlineFit: measuring the effect of each number.

#include "mesh/outline_fit.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr int ROUNDS = 8;
constexpr int MAX_MEASURED_VERTICES = 40000; // Number of vertices in all measurements together.
constexpr int MIN_EVALUATIONS = 120;
constexpr int MAX_EVALUATIONS = 1200;
constexpr int TRIES = 4; // Attempts along one round's direction, each shorter.
constexpr int PASSES = 3; // Numbers at their limits leave the rest to the remaining ones.
constexpr float ALLOWED = 0.04f; // A larger error causes further starting points.
constexpr float TURNS[] = { 0.0f, 0.2f, -0.2f, 0.4f, -0.4f };
constexpr float FLOWER = 0.2f; // Weight of flowers relative to other units: they determine the plant's colour.
constexpr float PROBE = 0.06f;
constexpr float MAX_SHIFT = 0.6f; // Maximum change of a number per round.
constexpr float FIRST_DAMPING = 0.03f;
constexpr float MIN_DAMPING = 1e-4f;
constexpr float LESS_DAMPING = 0.3f;
constexpr float MORE_DAMPING = 5.0f;

float squares(const Outlines &errors) {
	float sum = 0.0f;
	for (const float error : errors) {
		sum += error * error;
	}
	return sum;
}

float worst_of(const Outlines &errors) {
	float worst = 0.0f;
	for (const float error : errors) {
		worst = std::max(worst, std::abs(error));
	}
	return worst;
}

/// Finds the smallest changes of the numbers that are not `fixed` that correct the errors. For fixed numbers, `changes`
/// has what they did. Damping limits all changes.
void mend(const std::vector<Outlines> &slopes, const std::vector<float> &weights, const std::vector<bool> &fixed,
		const Outlines &errors, float damping, std::vector<float> &changes) {
	float matrix[OUTLINES][OUTLINES] = {};
	float right[OUTLINES];
	Outlines rest = errors;
	for (size_t n = 0; n < slopes.size(); n++) {
		for (size_t i = 0; i < OUTLINES; i++) {
			rest[i] += fixed[n] ? slopes[n][i] * changes[n] : 0.0f;
			for (size_t k = 0; k < OUTLINES; k++) {
				matrix[i][k] += fixed[n] ? 0.0f : slopes[n][i] * weights[n] * slopes[n][k];
			}
		}
	}
	float trace = 0.0f;
	for (size_t i = 0; i < OUTLINES; i++) {
		trace += matrix[i][i];
		right[i] = -rest[i];
	}
	for (size_t i = 0; i < OUTLINES; i++) {
		matrix[i][i] += damping * trace + 1e-9f;
	}
	solve_outlines(matrix, right);
	for (size_t n = 0; n < slopes.size(); n++) {
		float change = 0.0f;
		for (size_t i = 0; i < OUTLINES; i++) {
			change += weights[n] * slopes[n][i] * right[i];
		}
		change = std::isfinite(change) ? std::clamp(change, -MAX_SHIFT, MAX_SHIFT) : 0.0f;
		changes[n] = fixed[n] ? changes[n] : change;
	}
}

} // namespace

/// Goal and state of a search.
struct OutlineFit::Sought {
	const SightBox &box;
	const Outlines &wanted;
	size_t bundles;
	int evaluations; ///< Remaining measurements.
	float damping = FIRST_DAMPING;
	std::vector<Ways> from; ///< Widths of units at the beginning of a round.
	std::vector<float> weights; ///< By number (the ways of each bundle): larger weights change more.
	std::vector<Outlines> slopes; ///< By number: change of the errors.
};

/// A few units change independently. Many units are bundled by the side from which they are best visible.
size_t OutlineFit::bundle() {
	if (units.size() <= MAX_BUNDLES) {
		for (size_t u = 0; u < units.size(); u++) {
			units[u].bundle = u;
		}
		return units.size();
	}
	for (size_t u = 0; u < units.size(); u++) {
		const Outlines &area = units[u].area;
		const size_t side = static_cast<size_t>(std::max_element(area.begin(), area.end()) - area.begin());
		units[u].bundle = side + (written[u].is_flower ? OUTLINES : 0);
	}
	return MAX_BUNDLES;
}

/// Returns the error of each outline.
Outlines OutlineFit::evaluate(Sought &sought) const {
	sought.evaluations--;
	const SeenMesh seen = { mesh.positions, written.back().vertex, mesh.indices, written.back().index };
	Outlines errors = outline_areas(seen, sought.box);
	for (size_t side = 0; side < OUTLINES; side++) {
		errors[side] = errors[side] / sought.wanted[side] - 1.0f;
	}
	return errors;
}

/// Sets the units to the state at the beginning of the round plus `changes`. Limits reduce the changes; `changes` then
/// has the reduced ones, averaged over each bundle.
void OutlineFit::place(const Sought &sought, std::vector<float> &changes) {
	std::vector<float> sums(changes.size(), 0.0f);
	std::vector<float> counts(sought.bundles, 0.0f);
	for (size_t u = 0; u < units.size(); u++) {
		Unit &unit = units[u];
		const size_t first = unit.bundle * WAYS;
		const float width = 1.0f + sought.from[u][0];
		for (size_t way = 0; way < WAYS; way++) {
			unit.widths[way] = sought.from[u][way] + changes[first + way] * (way == TURN ? 1.0f : width);
		}
		limit(u, unit.widths);
		counts[unit.bundle] += 1.0f;
		for (size_t way = 0; way < WAYS; way++) {
			sums[first + way] += (unit.widths[way] - sought.from[u][way]) / (way == TURN ? 1.0f : width);
		}
		apply(u, unit.widths);
	}
	for (size_t n = 0; n < changes.size(); n++) {
		changes[n] = sums[n] / std::max(counts[n / WAYS], 1.0f);
	}
}

void OutlineFit::probe(Sought &sought, const Outlines &errors) {
	const size_t numbers = sought.bundles * WAYS;
	sought.slopes.assign(numbers, {});
	for (size_t n = 0; n < numbers; n++) {
		for (const float shift : { PROBE, -PROBE }) { // Backwards if the number is at its limit.
			std::vector<float> changes(numbers, 0.0f);
			changes[n] = shift;
			place(sought, changes);
			if (std::abs(changes[n]) > 0.5f * PROBE) {
				const Outlines now = evaluate(sought);
				for (size_t side = 0; side < OUTLINES; side++) {
					sought.slopes[n][side] = (now[side] - errors[side]) / changes[n];
				}
				break;
			}
		}
	}
}

/// Takes a step to where the slopes predict correct outlines, or shorter ones if that fails. Returns false if no step
/// improves.
bool OutlineFit::step(Sought &sought, Outlines &errors) {
	for (int tries = 0; tries < TRIES; tries++) {
		std::vector<bool> fixed(sought.slopes.size(), false);
		std::vector<float> changes(sought.slopes.size(), 0.0f);
		for (int pass = 0; pass < PASSES; pass++) {
			mend(sought.slopes, sought.weights, fixed, errors, sought.damping, changes);
			const std::vector<float> wishes = changes;
			place(sought, changes);
			for (size_t n = 0; n < changes.size(); n++) {
				fixed[n] = fixed[n] || std::abs(changes[n] - wishes[n]) > 1e-3f;
			}
		}
		const Outlines now = evaluate(sought);
		if (squares(now) < squares(errors)) {
			errors = now;
			sought.damping = std::max(sought.damping * LESS_DAMPING, MIN_DAMPING);
			return true;
		}
		sought.damping *= MORE_DAMPING;
	}
	return false;
}

/// The weight of a bundle is that of its units together.
std::vector<float> OutlineFit::bundle_weights(size_t bundles) const {
	std::vector<float> weights(bundles * WAYS, 0.0f);
	for (size_t u = 0; u < units.size(); u++) {
		const Unit &unit = units[u];
		for (size_t way = 0; way < WAYS; way++) {
			float &weight = weights[unit.bundle * WAYS + way];
			const float own = unit.weight[way] * (written[u].is_flower ? FLOWER : 1.0f);
			weight = weight > 0.0f && own > 0.0f ? 1.0f / (1.0f / weight + 1.0f / own) : std::max(weight, own);
		}
	}
	return weights;
}

/// Starts from the present widths of the units.
void OutlineFit::go_on(Sought &sought, float goal, float &worst) {
	Outlines errors = evaluate(sought);
	sought.damping = FIRST_DAMPING;
	for (int round = 0; round < ROUNDS && worst > goal && sought.evaluations > 0; round++) {
		sought.from.clear();
		for (const Unit &unit : units) {
			sought.from.push_back(unit.widths);
		}
		probe(sought, errors);
		if (!step(sought, errors)) {
			return;
		}
		if (worst_of(errors) < worst) {
			worst = worst_of(errors);
			keep();
		}
	}
}

void OutlineFit::search(const SightBox &box, const Outlines &wanted, float goal, float &worst) {
	const size_t bundles = bundle();
	const int evaluations =
			std::clamp(MAX_MEASURED_VERTICES / std::max(written.back().vertex, 1), MIN_EVALUATIONS, MAX_EVALUATIONS);
	Sought sought = { box, wanted, bundles, evaluations, FIRST_DAMPING, {}, bundle_weights(bundles), {} };
	finish();
	go_on(sought, goal, worst);
	for (const float turn : TURNS) { // Some local minima of the error have no way out.
		if (worst < ALLOWED || sought.evaluations <= 0) {
			break;
		}
		for (size_t u = 0; u < units.size(); u++) {
			units[u].widths = { 0.0f, 0.0f, 0.0f, turn };
			apply(u, units[u].widths);
		}
		go_on(sought, goal, worst);
	}
	finish();
	turn_normals();
}

/// Normals turn with the sheets.
void OutlineFit::turn_normals() {
	for (size_t u = 0; u < units.size(); u++) {
		const HalfTurn turn(units[u].saved[TURN]);
		for (int i = written[u].vertex; i < written[u + 1].vertex && units[u].saved[TURN] != 0.0f; i++) {
			mesh.normals[i] = glm::normalize(turn.of(mesh.normals[i]));
		}
	}
}

} // namespace undergrowth

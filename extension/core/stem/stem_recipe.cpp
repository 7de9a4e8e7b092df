#include "stem/stem_recipe.hpp"

#include "stem/stem_shape.hpp"

#include <algorithm>

namespace undergrowth {

static StemSolution solve_or_bare(const StemBeam &beam, StemFault &fault) {
	const StemSolution solution = solve_stem(beam);
	if (solution.fault == StemFault::none) {
		return solution;
	}
	fault = solution.fault;
	StemBeam bare;
	bare.length = std::clamp(beam.length, SHORTEST_STEM, LONGEST_STEM);
	bare.joints = beam.joints;
	bare.modes = beam.modes;
	return solve_stem(bare);
}

// The weight of the joints counts, too.
static float usual_weight_of(const StemBeam &beam, const StemConstants &stem) {
	StemBeam plain = beam;
	plain.wind_weights.clear();
	const float slope = beam.wind_weights.empty() ? stem.dead_slope : solve_stem(plain).constants.dead_slope;
	const float frequency = stem.mode[0].frequency;
	return 1.0f / (frequency * frequency * stem.length * slope);
}

SolvedStem solve_recipe(const StemRecipe &recipe) {
	SolvedStem solved;
	StemConstants stem = solve_or_bare(recipe.beam, solved.fault).constants;
	float weight = recipe.wind_weight;
	if (weight < 0.0f) {
		weight = recipe.usual_weight;
		if (weight == 0.0f) {
			StemBeam own = recipe.beam;
			own.length = recipe.own_length;
			const bool is_own = own.length == recipe.beam.length;
			weight = usual_weight_of(own, is_own ? stem : solve_or_bare(own, solved.fault).constants);
		}
		solved.usual_weight = weight;
	}
	stem.dead_slope *= weight;
	solved.in_newtons = std::make_shared<const StemConstants>(stem);
	solved.in_air = std::make_shared<const StemConstants>(in_air(stem));
	return solved;
}

} // namespace undergrowth

#pragma once

#include "stem/stem_beam.hpp"

#include <memory>

namespace undergrowth {

constexpr float SHORTEST_STEM = 0.005f; ///< m.
constexpr float LONGEST_STEM = 100.0f;

/// Input from which the stem constants of one plant height are computed.
struct StemRecipe {
	StemBeam beam;
	/// Factor of wind forces. Below 0: a default for a plant of `own_length`, since default winds have forces for
	/// kilograms and most stems weigh grams.
	float wind_weight = -1.0f;
	float usual_weight = 0.0f; ///< The default weight if it was computed before; 0: compute it.
	float own_length = 0.6f; ///< m, of the species' own plants.
};

/// Solution of a recipe.
struct SolvedStem {
	std::shared_ptr<const StemConstants> in_newtons;
	std::shared_ptr<const StemConstants> in_air; ///< The same stem in a wind in m/s (in_air()).
	StemFault fault = StemFault::none; ///< On a fault the constants are those of a bare stem of about 1.5 Hz.
	float usual_weight = 0.0f; ///< 0 if the recipe has its own weight.
};

/// Any thread. Takes about half a millisecond.
SolvedStem solve_recipe(const StemRecipe &recipe);

} // namespace undergrowth

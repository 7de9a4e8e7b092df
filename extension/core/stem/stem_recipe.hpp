#pragma once

#include "stem/stem_beam.hpp"

#include <memory>

namespace undergrowth {

constexpr float SHORTEST_STEM = 0.005f; ///< m.
constexpr float LONGEST_STEM = 100.0f;

/// All that the stem of a species' plants of one height follows from.
struct StemRecipe {
	StemBeam beam;
	/// Times what newtons do to it; below 0 as much as suits most stems, by a plant of `own_length`: a new wind blows
	/// with newtons that suit kilograms, and most stems weigh grams.
	float wind_weight = -1.0f;
	float usual_weight = 0.0f; ///< That weight, where it is known; 0: it is found.
	float own_length = 0.6f; ///< m, of the species' own plants.
};

/// What a recipe comes to.
struct SolvedStem {
	std::shared_ptr<const StemConstants> in_newtons;
	std::shared_ptr<const StemConstants> in_air; ///< The same stem in a wind in m/s (in_air()).
	StemFault fault = StemFault::none; ///< With one, these are of a bare stem that swings at about 1.5 Hz.
	float usual_weight = 0.0f; ///< 0 where a recipe has a weight of its own.
};

/// Any thread. Takes about half a millisecond.
SolvedStem solve_recipe(const StemRecipe &recipe);

} // namespace undergrowth

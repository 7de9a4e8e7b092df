#pragma once

#include "motion/motion_species.hpp"
#include "plant_stem.hpp"
#include "sampled_plant.hpp"
#include "stem/stem_recipe.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>

namespace undergrowth {

/// A stem that a species does not know yet, to be solved on any thread (solve_recipe()).
struct AskedStem {
	StemRecipe recipe;
	int height_class = 0;
	uint64_t era = 0; ///< Of the species that asks; another one since then has other stems.
};

/// A stem that is being solved. Fields that need the same one at the same time share it: the first solves it, on any
/// thread, and the others wait.
class SharedStem {
public:
	/// The one that others use already, or a new one.
	static std::shared_ptr<SharedStem> of(const AskedStem &asked);
	const SolvedStem &solve(const AskedStem &asked);

private:
	std::once_flag is_solved;
	SolvedStem solved;
};

/// The stems of one species, solved once for each height that needs its own: where frequency is declared, for one
/// height, and where it follows from stiffness, for heights a tenth apart. Main thread.
class StemTable {
public:
	/// Forgets everything: the species looks different.
	void clear() { *this = StemTable(); }
	/// Forgets what was solved, but not what its plants look like: they move otherwise.
	void forget_stems();
	/// Whether it knows what its plants look like. It has to, before it is asked.
	bool knows_plants() const { return drawn.length > 0.0f; }
	/// Takes over what one of them, of the species' own height, says of its stem.
	void learn(const SampledPlant &plant);

	/// Asks for the stem of a plant of `height` metres, one of the species' own where that is 0; `stem` may be null.
	AskedStem ask(float height, const Motion &motion, const godot::Ref<PlantStem> &stem) const;
	/// What is known of it; null before it is solved.
	const SolvedStem *find(const AskedStem &asked) const;
	/// Takes over what it came to, unless the species has changed meanwhile. Where nothing can stand so, problem() says
	/// what is wrong.
	void take(const AskedStem &asked, const SolvedStem &found);
	/// In English; empty where all stems stand.
	const godot::String &problem() const { return fault; }

private:
	std::map<int, SolvedStem> solved; ///< By class of height; 0 is that of `drawn`.
	StemBeam drawn = nothing();
	godot::String fault;
	float usual = 0.0f; ///< What the usual wind weight comes to, that of `drawn` for all heights; 0: not known yet.
	uint64_t era = next_era();

	static StemBeam nothing();
	static uint64_t next_era();
};

} // namespace undergrowth

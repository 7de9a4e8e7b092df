#pragma once

#include "motion/motion_species.hpp"
#include "species/plant_stem.hpp"
#include "species/sampled_plant.hpp"
#include "stem/stem_recipe.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>

namespace undergrowth {

/// A stem that its species has not solved. solve_recipe() solves it on any thread.
struct UnsolvedStem {
	StemRecipe recipe;
	int height_class = 0;
	uint64_t era = 0; ///< Of the species; a species with another one has other stems.
};

/// A stem that is being solved. Fields that need the same stem at the same time share it. The first thread solves it
/// and the other ones wait.
class SharedStem {
public:
	/// Returns the existing one for an equal request, or a new one.
	static std::shared_ptr<SharedStem> of(const UnsolvedStem &unsolved);
	const SolvedStem &solve(const UnsolvedStem &unsolved);

private:
	std::once_flag is_solved;
	SolvedStem solved;
};

/// The stems of one species, solved once for each height class. There is one class if the frequency is declared. If
/// stiffness determines it, classes are heights that differ by a tenth. Main thread.
class StemTable {
public:
	/// Removes everything. Call when the appearance of the species changes.
	void clear() { *this = StemTable(); }
	/// Removes the solved stems and retains the appearance of the plants. Call when their motion changes.
	void forget_stems();
	/// True after learn(). ask() needs it.
	bool has_drawn_plants() const { return drawn.length > 0.0f; }
	/// Reads the shape of the stem from a plant of the species' own height.
	void learn(const SampledPlant &plant);

	/// Returns the request for the stem of a plant of `height` metres; 0 is the species' own height. `stem` may be
	/// null.
	UnsolvedStem unsolved_for(float height, const Motion &motion, const godot::Ref<PlantStem> &stem) const;
	/// Returns the solved stem, or null.
	const SolvedStem *find(const UnsolvedStem &unsolved) const;
	/// Stores the result, unless the species has changed since the request. If the stem has a fault, problem()
	/// describes it.
	void take(const UnsolvedStem &unsolved, const SolvedStem &found);
	/// In English; empty if no stem has a fault.
	const godot::String &problem() const { return fault; }

private:
	std::map<int, SolvedStem> solved; ///< By height class; 0 is that of `drawn`.
	StemBeam drawn = nothing();
	godot::String fault;
	float usual = 0.0f; ///< Result of the usual wind weight for `drawn`, used for all heights; 0: not solved.
	uint64_t era = next_era();

	static StemBeam nothing();
	static uint64_t next_era();
};

} // namespace undergrowth

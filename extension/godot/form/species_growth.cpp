#include "form/species_growth.hpp"

#include "base/follow_changes.hpp"
#include "base/stopwatch.hpp"
#include "form/grown_plant.hpp"
#include "species/plant_function.hpp"
#include "species/shared_resources.hpp"
#include "species/species_sampling.hpp"

#include <algorithm>
#include <vector>

using namespace godot;

namespace undergrowth {

static constexpr double SLOW_GROWTH = 1.0; // s: above it the game halts noticeably.

String SpeciesGrowth::sample(PlantFunction &species, double height, int segments, int64_t seed, SampledPlant &result) {
	String problem = find_level_problem(segments);
	result.lod = segments;
	result.grown = problem.is_empty() ? grown_before.find(seed, state_of_script(&species)) : nullptr;
	if (problem.is_empty() && !result.grown) {
		problem = grow(species, seed, result.grown);
	}
	if (!problem.is_empty()) {
		return problem;
	}
	parts_material(); // On the main thread, this loads its shader. A field builds its meshes on
					  // worker threads, which cannot.
	result.height = height == 0.0 ? result.grown->form.height : float(height);
	return height == 0.0 ? String() : find_height_problem(height);
}

// The pictures of all fields show one plant of these seeds: the first one with all kinds of parts, or with most of
// them. Some plants have no flowers.
static constexpr int64_t FIRST_CARD_SEED = 1;
static constexpr int64_t LAST_CARD_SEED = 8;

static size_t count_kinds(const PlantForm &form) {
	std::vector<bool> is_placed(form.parts.size(), false);
	for (const PlacedPart &part : form.placed) {
		is_placed[size_t(part.kind)] = true;
	}
	return size_t(std::count(is_placed.begin(), is_placed.end(), true));
}

std::shared_ptr<SharedCards> SpeciesGrowth::cards(PlantFunction &species) {
	const int64_t state = state_of_script(&species);
	if (shared_cards && state_of_cards == state) {
		return shared_cards;
	}
	std::shared_ptr<const GrownPlant> shown;
	size_t kinds = 0;
	for (int64_t seed = FIRST_CARD_SEED; seed <= LAST_CARD_SEED; seed++) {
		std::shared_ptr<const GrownPlant> grown = grown_before.find(seed, state);
		if (!grown && !grow(species, seed, grown).is_empty()) {
			return nullptr;
		}
		const size_t own = count_kinds(grown->form);
		shown = !shown || own > kinds ? grown : shown;
		kinds = std::max(kinds, own);
		if (own == grown->form.parts.size()) {
			break;
		}
	}
	shared_cards = std::make_shared<SharedCards>(shown);
	state_of_cards = state;
	return shared_cards;
}

String SpeciesGrowth::grow(PlantFunction &species, int64_t seed, std::shared_ptr<const GrownPlant> &grown) {
	SampledPlant sampled;
	String problem = sample_height(species, 0.0, seed, sampled);
	if (!problem.is_empty()) {
		return problem;
	}
	// Connects at the first growth. Scripts emit no signal for changes inside of their variables.
	follow_changes(&species, Callable(&species, "_on_own_change"));
	follow_script_resources(&species, Callable(&species, "_on_grown_change"));
	Ref<PlantGrowth> plant;
	plant.instantiate();
	plant->begin(&species, sampled.height, uint64_t(seed));
	call_script(species, plant, problem);
	String what;
	PlantForm form = plant->finish(what);
	if (problem.is_empty()) {
		problem = what;
	}
	if (problem.is_empty()) {
		grown = std::make_shared<const GrownPlant>(std::move(form));
		grown_before.keep(seed, state_of_script(&species), grown);
	}
	return problem;
}

void SpeciesGrowth::call_script(PlantFunction &species, const Ref<PlantGrowth> &plant, String &problem) {
	const Stopwatch watch;
	const bool is_script = species.call_grow(plant, problem);
	const double seconds = 1e-6 * watch.usec();
	if (is_script && seconds > SLOW_GROWTH && !has_reported_slowness) {
		has_reported_slowness = true;
		report_warning(&species,
				"its `_grow` took " + String::num(seconds, 1) +
						" s for one plant and blocked the game. Compute what is equal for all seeds only once, or "
						"reduce the species' variants: a field calls `_grow` for each variant.");
	}
}

} // namespace undergrowth

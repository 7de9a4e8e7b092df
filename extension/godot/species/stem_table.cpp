#include "species/stem_table.hpp"

#include "form/grown_plant.hpp"
#include "mesh/form_stem.hpp"
#include "model/plant_model.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <tuple>

using namespace godot;

namespace undergrowth {

static constexpr double HEIGHT_RATIO = 1.1; // Of neighbouring height classes.

// An era has one recipe for each height class and usual weight.
std::shared_ptr<SharedStem> SharedStem::of(const UnsolvedStem &unsolved) {
	using Key = std::tuple<uint64_t, int, float>;
	static std::mutex mutex;
	static auto *const known = new std::map<Key, std::weak_ptr<SharedStem>>; // Worker threads may outlive statics.
	const std::lock_guard<std::mutex> lock(mutex);
	for (auto entry = known->begin(); entry != known->end();) {
		entry = entry->second.expired() ? known->erase(entry) : std::next(entry);
	}
	std::weak_ptr<SharedStem> &slot = (*known)[Key(unsolved.era, unsolved.height_class, unsolved.recipe.usual_weight)];
	std::shared_ptr<SharedStem> stem = slot.lock();
	if (!stem) {
		stem = std::make_shared<SharedStem>();
		slot = stem;
	}
	return stem;
}

const SolvedStem &SharedStem::solve(const UnsolvedStem &unsolved) {
	std::call_once(is_solved, [&] { solved = solve_recipe(unsolved.recipe); });
	return solved;
}

StemBeam StemTable::nothing() {
	StemBeam beam;
	beam.length = 0.0f;
	return beam;
}

uint64_t StemTable::next_era() {
	static std::atomic<uint64_t> last = 0; // Species are loaded on any thread.
	return ++last;
}

void StemTable::forget_stems() {
	solved.clear();
	usual = 0.0f;
	fault = String();
	era = next_era();
}

void StemTable::learn(const SampledPlant &plant) {
	drawn = StemBeam();
	drawn.length = std::clamp(plant.height, SHORTEST_STEM, LONGEST_STEM); // Other lengths are scaled from it.
	if (plant.model) {
		const float length = drawn.length;
		drawn = plant.model->found().beam;
		drawn.length = length;
		drawn.diameter = std::min(drawn.diameter, length);
	} else if (plant.grown) {
		carry_parts(plant.grown->form, drawn);
	} else {
		carry_lathe(plant.cross_section.radius, plant.widths, drawn);
	}
}

UnsolvedStem StemTable::unsolved_for(float height, const Motion &motion, const Ref<PlantStem> &stem) const {
	const bool is_physical = stem.is_valid() && stem->is_physical();
	const double ratio = height > 0.0f ? double(height) / double(drawn.length) : 1.0;
	UnsolvedStem unsolved;
	unsolved.era = era;
	unsolved.height_class = is_physical ? int(std::lround(std::log(ratio) / std::log(HEIGHT_RATIO))) : 0;
	StemRecipe &recipe = unsolved.recipe;
	recipe.beam = drawn;
	recipe.beam.length *= float(std::pow(HEIGHT_RATIO, unsolved.height_class));
	if (motion.frequency_height > 0.0f && !is_physical) {
		recipe.beam.length = std::clamp(motion.frequency_height, SHORTEST_STEM, LONGEST_STEM);
		recipe.beam.frequency_by_length = true;
	}
	recipe.beam.natural_frequency = motion.natural_frequency;
	recipe.beam.damping_ratio = motion.damping_ratio;
	recipe.beam.frequency_deviation = motion.frequency_deviation;
	if (stem.is_valid()) {
		stem->write_to(recipe.beam);
	}
	recipe.wind_weight = motion.wind_weight;
	recipe.usual_weight = usual;
	recipe.own_length = drawn.length;
	return unsolved;
}

const SolvedStem *StemTable::find(const UnsolvedStem &unsolved) const {
	const auto known = solved.find(unsolved.height_class);
	return unsolved.era == era && known != solved.end() ? &known->second : nullptr;
}

void StemTable::take(const UnsolvedStem &unsolved, const SolvedStem &found) {
	if (unsolved.era != era) {
		return;
	}
	solved.emplace(unsolved.height_class, found);
	usual = found.usual_weight != 0.0f ? found.usual_weight : usual;
	if (found.fault != StemFault::none) {
		fault = String::utf8(describe(found.fault));
	}
}

} // namespace undergrowth

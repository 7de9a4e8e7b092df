#pragma once

#include "form/growth_cache.hpp"
#include "form/shared_cards.hpp"
#include "species/sampled_plant.hpp"

#include <godot_cpp/variant/string.hpp>

namespace undergrowth {

class PlantFunction;
class PlantGrowth;

/// Grows the plants of a species of parts, once for each seed until the species changes. Level and height have no
/// effect on it. Main thread: a species may be a script.
class SpeciesGrowth {
public:
	/// sample_lathe() for a species of parts.
	godot::String sample(PlantFunction &species, double height, int segments, int64_t seed, SampledPlant &result);
	/// Returns the cards of a species of parts, or null if the plant for them does not grow.
	std::shared_ptr<SharedCards> cards(PlantFunction &species);
	/// Removes all grown plants. Call when the species changes.
	void forget() {
		grown_before.clear();
		shared_cards.reset();
	}

private:
	GrowthCache grown_before;
	std::shared_ptr<SharedCards> shared_cards; ///< Of the present shapes; null until they are needed.
	int64_t state_of_cards = 0; ///< state_of_script() of these shapes.
	bool has_reported_slowness = false;

	godot::String grow(PlantFunction &species, int64_t seed, std::shared_ptr<const GrownPlant> &grown);
	void call_script(PlantFunction &species, const godot::Ref<PlantGrowth> &plant, godot::String &problem);
};

} // namespace undergrowth

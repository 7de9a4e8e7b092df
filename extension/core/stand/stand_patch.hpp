#pragma once

#include "stand/plant_store.hpp"

#include <unordered_map>
#include <vector>

namespace undergrowth {

/// Computes the edit that changes the plants of a rectangle to those of a new placement. Any thread.
class StandPatch {
public:
	/// `standing`: the generated plants in the rectangle, placed at `spacing` (m).
	StandPatch(StandingPlants &&standing, double spacing);

	/// Returns the plants of `placed` that are new or have another height or species; the caller puts them onto the
	/// ground. Existing plants that are not in `placed` are removed by the edit.
	FieldPlants find_newcomers(const FieldPlants &placed);
	/// Call after that, with the plants that have ground.
	StandEdit make_edit(const FieldPlants &newcomers) const;

private:
	StandingPlants before;
	double spacing; ///< m.
	std::unordered_map<PlantId, std::size_t> named; ///< Index in `before`.
	std::vector<PlantPlace> gone;
	std::unordered_map<PlantId, PlantPlace> changed;

	PlantId name_of(const FieldPlants &plants, std::size_t i) const;
};

} // namespace undergrowth

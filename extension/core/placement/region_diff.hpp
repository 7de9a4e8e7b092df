#pragma once

#include "placement/plant_store.hpp"

#include <unordered_map>
#include <vector>

namespace undergrowth {

/// Computes the edit that changes the plants of a rectangle to those of a new placement. Any thread.
class RegionDiff {
public:
	/// `existing`: the generated plants in the rectangle, placed at `spacing` (m).
	RegionDiff(ExistingPlants &&existing, double spacing);

	/// Returns the plants of `placed` that are new or have another height or species; the caller puts them onto the
	/// ground. Existing plants that are not in `placed` are removed by the edit.
	FieldPlants find_new_plants(const FieldPlants &placed);
	/// Call after that, with the plants that have ground.
	StoreEdit make_edit(const FieldPlants &new_plants) const;

private:
	ExistingPlants before;
	double spacing; ///< m.
	std::unordered_map<PlantId, std::size_t> by_id; ///< Index in `before`.
	std::vector<PlantRef> gone;
	std::unordered_map<PlantId, PlantRef> changed;

	PlantId id_of(const FieldPlants &plants, std::size_t i) const;
};

} // namespace undergrowth

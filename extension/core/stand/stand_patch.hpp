#pragma once

#include "stand/plant_store.hpp"

#include <unordered_map>
#include <vector>

namespace undergrowth {

/// What has to happen in a rectangle so that those stand there whom a placement has there now. On any thread.
class StandPatch {
public:
	/// `standing`: who was filled and stands in the rectangle, at `spacing` (m).
	StandPatch(StandingPlants &&standing, double spacing);

	/// Of all who are to stand in it, those who do not stand so yet: new ones, and those who are otherwise high or of
	/// another kind. Whoever else stands there goes. They are yet to be put onto the ground.
	FieldPlants find_newcomers(const FieldPlants &placed);
	/// After that: with those of them whom the ground holds.
	StandEdit make_edit(const FieldPlants &newcomers) const;

private:
	StandingPlants before;
	double spacing; ///< m.
	std::unordered_map<PlantId, std::size_t> named; ///< Of `before`.
	std::vector<PlantPlace> gone;
	std::unordered_map<PlantId, PlantPlace> changed;

	PlantId name_of(const FieldPlants &plants, std::size_t i) const;
};

} // namespace undergrowth

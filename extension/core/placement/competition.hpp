#pragma once

#include "placement/area.hpp"
#include "placement/plants.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// How a species competes with others.
struct Competitor {
	float vigor = 1.0f; ///< > 0. Multiplies the size of a plant; the larger of two plants shades the other one.
	float shade_radius = 0.0f; ///< m, of a plant of scale 1, 0 to Competition::MAX_RADIUS.
	float shade_tolerance = 0.0f; ///< 0 to 1: chance that a plant survives in full shade.
};

/// Competition between the species of a field. Plants die in the shade of larger plants of other species. A plant's
/// fate depends only on the placed plants within reach() around it, not on their fates, so that tiles can be built in
/// any order.
struct Competition {
	static constexpr float MAX_RADIUS = 4.0f; ///< m.

	float strength = 0.0f; ///< 0: none; 1: full.
	std::vector<Competitor> species;
	uint64_t seed = 0;

	/// Larger plants shade as plants of this scale.
	static constexpr float CROWN_SCALE = 2.0f;

	bool is_on() const { return strength > 0.0f; }
	/// m: no plant shades farther. 0 without competition.
	float reach() const;
};

/// Removes plants that die in the shade of others, with their entries in `heights` and `normals` (as
/// thin_by_habitats()).
void compete(const Competition &competition, FieldPlants &plants, std::vector<float> &heights,
		std::vector<glm::vec3> &normals);

} // namespace undergrowth

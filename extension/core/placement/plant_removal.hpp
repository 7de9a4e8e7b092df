#pragma once

#include "placement/area.hpp"
#include "placement/plants.hpp"

#include <glm/vec3.hpp>

#include <vector>

namespace undergrowth {

/// Removes plants with their entries in `heights` and `normals`, which are empty or have one entry per plant. Indices
/// ascend and do not repeat.
void remove_plants(const std::vector<int> &ascending, FieldPlants &plants, std::vector<float> &heights,
		std::vector<glm::vec3> &normals);

/// The same for all plants outside of a box (m).
void crop_plants(const AreaBox &box, FieldPlants &plants, std::vector<float> &heights, std::vector<glm::vec3> &normals);

} // namespace undergrowth

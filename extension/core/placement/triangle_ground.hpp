#pragma once

#include "placement/plants.hpp"

#include <glm/vec3.hpp>

#include <vector>

namespace undergrowth {

/// Ground to use where several are above each other.
enum class GroundChoice {
	highest, ///< Roofs, bridges.
	lowest, ///< What is below them.
};

/// Ground from triangles. Writes a height and a normal per plant for apply_ground(): those of the highest or lowest
/// triangle above or below it; a height of NaN if there is none.
/// `corners`: three points (m, field axes) for each triangle, of either orientation; vertical triangles are
/// ignored.
void find_ground(const glm::vec3 *corners, int triangle_count, GroundChoice choice, const FieldPlants &plants,
		std::vector<float> &heights, std::vector<glm::vec3> &normals);

} // namespace undergrowth

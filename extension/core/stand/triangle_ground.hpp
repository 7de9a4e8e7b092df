#pragma once

#include "stand/plants.hpp"

#include <glm/vec3.hpp>

#include <vector>

namespace undergrowth {

/// Which of several grounds above each other counts.
enum class GroundChoice {
	highest, ///< Roofs, bridges.
	lowest, ///< What is below them.
};

/// Ground made of triangles: what plants stand on where that is a mesh. Heights and normals for apply_ground(), one of
/// each for each plant: those of the highest or lowest triangle above or below it; a height of NaN where there is
/// none.
/// `corners`: three points (m, field axes) for each triangle, which may go round either way; upright ones are no
/// ground.
void find_ground(const glm::vec3 *corners, int triangle_count, GroundChoice choice, const FieldPlants &plants,
		std::vector<float> &heights, std::vector<glm::vec3> &normals);

} // namespace undergrowth

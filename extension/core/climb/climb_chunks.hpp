#pragma once

#include "climb/climb_growth.hpp"

#include <glm/vec3.hpp>

#include <vector>

namespace undergrowth {

/// Consecutive points of a shoot: first … first + count - 1.
struct StemRun {
	int first = 0;
	int count = 0;
};

/// What is drawn together: the leaves and stems of one body in a cube.
struct ClimbChunk {
	int body = 0;
	std::vector<int> leaves; ///< Any prefix is spread evenly.
	std::vector<StemRun> stems; ///< A run ends where the next chunk's begins.
};

/// Divides a plant into cubes of `size` metres. Every leaf and every segment is in one chunk.
std::vector<ClimbChunk> divide_climb(const Climb &climb, float size);

/// Leaves that move alike: those of one body within a cube that have a similar surface.
struct ClimbCell {
	int body = 0;
	int leaves = 0;
	glm::vec3 place = { 0.0f, 0.0f, 0.0f }; ///< m, mean of the leaves.
	glm::vec3 normal = { 0.0f, 1.0f, 0.0f }; ///< Unit.
};

struct ClimbCells {
	std::vector<ClimbCell> cells;
	std::vector<int> of_leaves; ///< By leaf: index of its cell.
};

/// At most `max` cells, of `size` metres or larger.
ClimbCells find_cells(const Climb &climb, float size, int max);

} // namespace undergrowth

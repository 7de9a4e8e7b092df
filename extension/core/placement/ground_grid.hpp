#pragma once

#include "placement/plants.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Heights of the ground at the points of a square grid, and the ground between them, for plants of which each would
/// need a query of its own otherwise. Points lie a spacing apart, in places that do not depend on the plants.
///
/// Use: prepare(), mark() for all plants, list_points(), set_height() for each point, find() for each plant.
class GroundGrid {
public:
	/// m. Where heights bend by more from point to point, plants need a query of their own. On curved ground and at
	/// creases the heights found are then off by a quarter of this at most, beside a step by all of it.
	static constexpr float MAX_BEND = 0.05f;

	/// `spacing`: m, > 0. False where a grid costs more than it saves: where few plants lie far apart.
	bool prepare(const FieldPlants &plants, float spacing);
	/// Marks what the plants `begin` to `end` - 1 need. Each is one of those prepare() was called with.
	void mark(const FieldPlants &plants, int begin, int end);
	/// The points that marked plants need, row by row. Their number is valid until the next mark().
	int list_points();
	/// m, field axes: x and z.
	glm::vec2 point(int number) const;
	/// NaN where there is no ground.
	void set_height(int number, float height) {
		heights[static_cast<std::size_t>(points[std::size_t(number)])] = height;
	}
	/// Height and normal between the points. False at an edge of the ground or a step in it, where the place needs a
	/// query of its own. A height of NaN: no ground at any corner of the cell.
	bool find(float x, float z, float &height, glm::vec3 &normal) const;

private:
	float step = 1.0f; ///< m.
	int64_t first_column = 0; ///< Of the grid's first point, in steps.
	int64_t first_row = 0;
	int columns = 0; ///< Of points.
	int rows = 0;
	std::vector<uint8_t> marks; ///< By cell, at the place of its first corner.
	std::vector<float> heights; ///< By point; NaN where there is none, or it is not needed.
	std::vector<int> points; ///< Needed ones.

	bool is_even(std::size_t corner) const;
};

} // namespace undergrowth

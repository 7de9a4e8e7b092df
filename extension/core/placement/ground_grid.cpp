#include "placement/ground_grid.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace undergrowth {

// Of a step. Edges of ground are often at whole metres, and heights exactly at an edge are unreliable.
static constexpr float OFFSET = 0.382f;
static constexpr int MARGIN = 1; // Points around a cell's corners, for a test of evenness.
static constexpr double MAX_CELLS_PER_PLANT = 4.0;

bool GroundGrid::prepare(const FieldPlants &plants, float spacing) {
	step = spacing;
	columns = rows = 0;
	if (plants.size() == 0) {
		return false;
	}
	const auto [low_x, high_x] = std::minmax_element(plants.x.begin(), plants.x.end());
	const auto [low_z, high_z] = std::minmax_element(plants.z.begin(), plants.z.end());
	const double column = std::floor(*low_x / step - OFFSET) - MARGIN;
	const double row = std::floor(*low_z / step - OFFSET) - MARGIN;
	const double width = std::floor(*high_x / step - OFFSET) - column + 2 + MARGIN;
	const double depth = std::floor(*high_z / step - OFFSET) - row + 2 + MARGIN;
	const double spare = 256.0; // Points, for the margin of a small field.
	if (!(width * depth <= MAX_CELLS_PER_PLANT * plants.size() + spare)) {
		return false;
	}
	first_column = static_cast<int64_t>(column);
	first_row = static_cast<int64_t>(row);
	columns = static_cast<int>(width);
	rows = static_cast<int>(depth);
	const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
	marks.assign(count, 0);
	heights.assign(count, std::numeric_limits<float>::quiet_NaN());
	points.clear();
	return true;
}

void GroundGrid::mark(const FieldPlants &plants, int begin, int end) {
	for (std::size_t i = std::size_t(begin); i < std::size_t(end); i++) {
		const auto column = static_cast<int64_t>(std::floor(plants.x[i] / step - OFFSET)) - first_column;
		const auto row = static_cast<int64_t>(std::floor(plants.z[i] / step - OFFSET)) - first_row;
		marks[static_cast<std::size_t>(row * columns + column)] = 1;
	}
}

int GroundGrid::list_points() {
	points.clear();
	// A point serves the cells up to two before it and one after it, in both directions: first by rows, then by
	// columns.
	std::vector<uint8_t> wide(marks.size(), 0);
	for (int row = 0; row < rows; row++) {
		const std::size_t start = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns);
		for (int column = MARGIN; column + 1 + MARGIN < columns; column++) {
			if (marks[start + std::size_t(column)] != 0) {
				std::fill_n(wide.begin() + std::ptrdiff_t(start) + column - MARGIN, 2 + 2 * MARGIN, uint8_t(1));
			}
		}
	}
	for (int row = 0; row < rows; row++) {
		const int low = std::max(row - 1 - MARGIN, 0);
		const int high = std::min(row + MARGIN, rows - 1);
		for (int column = 0; column < columns; column++) {
			bool is_needed = false;
			for (int other = low; other <= high && !is_needed; other++) {
				is_needed = wide[std::size_t(other) * std::size_t(columns) + std::size_t(column)] != 0;
			}
			if (is_needed) {
				points.push_back(row * columns + column);
			}
		}
	}
	return static_cast<int>(points.size());
}

glm::vec2 GroundGrid::point(int number) const {
	const int place = points[static_cast<std::size_t>(number)];
	return { static_cast<float>((static_cast<double>(first_column + place % columns) + OFFSET) * step),
		static_cast<float>((static_cast<double>(first_row + place / columns) + OFFSET) * step) };
}

// True if heights continue evenly from each corner of a cell to both sides. Points without ground are ignored.
bool GroundGrid::is_even(std::size_t corner) const {
	const auto width = static_cast<std::size_t>(columns);
	for (const std::size_t along : { std::size_t(1), width }) {
		const std::size_t across = along == 1 ? width : 1;
		for (const std::size_t start : { corner, corner + across }) {
			for (const std::size_t middle : { start, start + along }) {
				const float bend = heights[middle - along] - 2.0f * heights[middle] + heights[middle + along];
				if (bend > MAX_BEND || bend < -MAX_BEND) {
					return false;
				}
			}
		}
	}
	return true;
}

bool GroundGrid::find(float x, float z, float &height, glm::vec3 &normal) const {
	const float column = std::floor(x / step - OFFSET);
	const float row = std::floor(z / step - OFFSET);
	const auto width = static_cast<std::size_t>(columns);
	const std::size_t corner = static_cast<std::size_t>(static_cast<int64_t>(row) - first_row) * width +
			static_cast<std::size_t>(static_cast<int64_t>(column) - first_column);
	const std::array<float, 4> at = { heights[corner], heights[corner + 1], heights[corner + width],
		heights[corner + width + 1] };
	const auto found = std::count_if(at.begin(), at.end(), [](float one) { return std::isfinite(one); });
	normal = { 0.0f, 1.0f, 0.0f };
	if (found == 0) {
		height = std::numeric_limits<float>::quiet_NaN();
		return true;
	}
	const float twist = at[0] - at[1] - at[2] + at[3];
	if (found < 4 || std::abs(twist) > MAX_BEND || !is_even(corner)) {
		return false;
	}
	const float right = x / step - OFFSET - column;
	const float front = z / step - OFFSET - row;
	const float near = glm::mix(at[0], at[1], right);
	const float far = glm::mix(at[2], at[3], right);
	height = glm::mix(near, far, front);
	normal.x = -glm::mix(at[1] - at[0], at[3] - at[2], front) / step;
	normal.z = -(far - near) / step;
	return true;
}

} // namespace undergrowth

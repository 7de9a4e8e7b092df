#pragma once

#include "placement/area.hpp"
#include "placement/habitat_raster.hpp"

#include <glm/vec2.hpp>

#include <cstddef>
#include <vector>

namespace undergrowth {

/// Heights of the ground at the points of a square grid.
struct HeightGrid {
	glm::vec2 low = { 0.0f, 0.0f }; ///< m, first point.
	float step = 1.0f; ///< m, > 0.
	int columns = 0;
	int rows = 0;
	std::vector<float> heights; ///< m, row by row; NaN: no ground.

	/// A grid without ground that covers a box and a margin (m), with at most `max_points` along a side and a step of
	/// `min_step` (m) or more.
	static HeightGrid around(const AreaBox &box, float margin, int max_points, float min_step);

	std::size_t size() const { return heights.size(); }
	std::size_t index(int column, int row) const {
		return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
	}
	/// Position (m) of a point.
	glm::vec2 point(std::size_t number) const;
	/// Slope (m/m) along x and z at a point, from the neighbours that exist; 0 without any.
	glm::dvec2 gradient(int column, int row) const;
	/// A raster with this value at all points.
	HabitatRaster raster(float value) const;

private:
	double rise(std::size_t here, bool has_before, bool has_after, std::size_t apart) const;
};

} // namespace undergrowth

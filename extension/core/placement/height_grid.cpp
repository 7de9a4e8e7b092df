#include "placement/height_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace undergrowth {

HeightGrid HeightGrid::around(const AreaBox &box, float margin, int max_points, float min_step) {
	const glm::vec2 size = box.high - box.low + 2.0f * margin;
	HeightGrid grid;
	grid.low = box.low - margin;
	grid.step = std::max(min_step, std::max(size.x, size.y) / static_cast<float>(max_points - 1));
	const auto count = [&](float metres) {
		return std::clamp(static_cast<int>(std::ceil(metres / grid.step)) + 1, 2, max_points);
	};
	grid.columns = count(size.x);
	grid.rows = count(size.y);
	grid.heights.assign(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows),
			std::numeric_limits<float>::quiet_NaN());
	return grid;
}

glm::vec2 HeightGrid::point(std::size_t number) const {
	const auto width = static_cast<std::size_t>(columns);
	return { low.x + static_cast<float>(number % width) * step, low.y + static_cast<float>(number / width) * step };
}

double HeightGrid::rise(std::size_t here, bool has_before, bool has_after, std::size_t apart) const {
	const double height = heights[here];
	const double before = has_before ? static_cast<double>(heights[here - apart]) : NAN;
	const double after = has_after ? static_cast<double>(heights[here + apart]) : NAN;
	const int count = (std::isfinite(before) ? 1 : 0) + (std::isfinite(after) ? 1 : 0);
	const double from = std::isfinite(before) ? before : height;
	const double to = std::isfinite(after) ? after : height;
	return count > 0 ? (to - from) / (count * static_cast<double>(step)) : 0.0;
}

glm::dvec2 HeightGrid::gradient(int column, int row) const {
	const std::size_t here = index(column, row);
	return { rise(here, column > 0, column + 1 < columns, 1),
		rise(here, row > 0, row + 1 < rows, static_cast<std::size_t>(columns)) };
}

HabitatRaster HeightGrid::raster(float value) const {
	HabitatRaster raster;
	raster.cell = { step, step };
	raster.low = low - 0.5f * step;
	raster.columns = columns;
	raster.rows = rows;
	raster.values.assign(size(), value);
	return raster;
}

} // namespace undergrowth

#include "placement/habitat_raster.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace undergrowth {

namespace {

/// Index of a cell that may lie beyond the `count` cells.
std::size_t index_of(double index, int count, bool repeats) {
	if (repeats) {
		index -= count * std::floor(index / count);
	}
	return static_cast<std::size_t>(std::clamp(index, 0.0, static_cast<double>(count - 1)));
}

} // namespace

float HabitatRaster::value(double column, double row) const {
	return values[index_of(row, rows, repeats) * static_cast<std::size_t>(columns) +
			index_of(column, columns, repeats)];
}

float HabitatRaster::at(const glm::vec2 &place) const {
	if (values.empty()) {
		return 1.0f;
	}
	const double x = (static_cast<double>(place.x) - static_cast<double>(low.x)) / static_cast<double>(cell.x) - 0.5;
	const double z = (static_cast<double>(place.y) - static_cast<double>(low.y)) / static_cast<double>(cell.y) - 0.5;
	const double column = std::floor(x);
	const double row = std::floor(z);
	const auto across = static_cast<float>(x - column);
	const auto along = static_cast<float>(z - row);
	const float near = value(column, row) + (value(column + 1.0, row) - value(column, row)) * across;
	const float far = value(column, row + 1.0) + (value(column + 1.0, row + 1.0) - value(column, row + 1.0)) * across;
	return near + (far - near) * along;
}

} // namespace undergrowth

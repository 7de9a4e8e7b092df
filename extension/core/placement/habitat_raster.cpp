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

template <class Value> float HabitatRaster::mix(const glm::vec2 &place, Value value_at) const {
	const double x = (static_cast<double>(place.x) - static_cast<double>(low.x)) / static_cast<double>(cell.x) - 0.5;
	const double z = (static_cast<double>(place.y) - static_cast<double>(low.y)) / static_cast<double>(cell.y) - 0.5;
	const double column = std::floor(x);
	const double row = std::floor(z);
	const auto across = static_cast<float>(x - column);
	const auto along = static_cast<float>(z - row);
	const auto between = [&](double of_row) {
		const float before = value_at(column, of_row);
		return before + (value_at(column + 1.0, of_row) - before) * across;
	};
	const float near = between(row);
	return near + (between(row + 1.0) - near) * along;
}

float HabitatRaster::at(const glm::vec2 &place) const {
	return values.empty() ? 1.0f : mix(place, [this](double column, double row) { return value(column, row); });
}

float HabitatRaster::at(const glm::vec2 &place, const HabitatCurve &curve) const {
	return values.empty() ? 1.0f : mix(place, [&](double column, double row) { return curve.at(value(column, row)); });
}

} // namespace undergrowth

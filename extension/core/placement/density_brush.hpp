#pragma once

#include "placement/density_map.hpp"

#include <glm/vec2.hpp>

namespace undergrowth {

/// A round brush for a DensityMap.
struct DensityBrush {
	static constexpr float MAX_RADIUS = 100.0f; ///< m.

	glm::vec2 centre = { 0.0f, 0.0f }; ///< m, (x, z).
	float radius = 1.0f; ///< m, > 0 up to MAX_RADIUS.
	float falloff = 0.5f; ///< 0: hard edge; 1: the weight decreases from the centre on.

	/// Weight at a distance (m) from the centre: 1 inside, 0 from the radius on.
	float weight(float distance) const;
};

/// Effect of a brush on the cells with centres in it.
struct DensityStroke {
	enum class Does {
		add, ///< Adds `value`, -1 to 1, to the density. A value below 0 also reduces plants/m² by that fraction.
		approach, ///< Moves the density to `value`, 0 to 1, and plants/m² to 0, by `strength` of the way.
		approach_plants, ///< Moves plants/m² to `value`, and the density to 0, by `strength` of the way.
		smooth, ///< Moves all values of a cell to the mean of nine cells, by `strength` of the way.
		set_height, ///< Moves the height factor to `value`, by `strength` of the way.
		set_scale_jitter, ///< Moves the jitter to `value`, 0 to 1, by `strength` of the way.
		set_color_jitter,
	};

	Does does = Does::add;
	float value = 1.0f;
	float strength = 1.0f; ///< 0 to 1.
};

/// True if all numbers are finite and in range, and the brush is within FARTHEST_COORDINATE.
bool is_valid(const DensityBrush &brush);

/// Applies a stroke. Returns a range that contains all changed cells. A weak stroke changes a cell by at least the
/// smallest step, so repeated strokes reach their value.
CellRange paint(DensityMap &map, int layer, const DensityBrush &brush, const DensityStroke &stroke);

/// Sets the density (0 to 1) of all cells with centres in a polygon, and their plants/m² to 0. Returns a range
/// that contains the changed cells. The polygon must have no fault.
CellRange fill_polygon(DensityMap &map, int layer, const Polygon &polygon, float density);

/// The same for plants/m² (0 to DensityCell::MAX_PLANT_DENSITY), with the density set to 0.
CellRange fill_polygon_plants(DensityMap &map, int layer, const Polygon &polygon, float plants);

/// Code of 0 to 1, in steps of 1/255.
uint8_t density_code(float density);
/// Code in steps of 1/64, from DensityCell::MIN_HEIGHT.
uint8_t height_code(float factor);
/// Code of plants/m², 0 to DensityCell::MAX_PLANT_DENSITY.
uint16_t plants_code(float plants);

} // namespace undergrowth

#pragma once

#include "stand/density_map.hpp"

#include <glm/vec2.hpp>

namespace undergrowth {

/// A round brush on a DensityMap.
struct DensityBrush {
	static constexpr float MOST_RADIUS = 100.0f; ///< m.

	glm::vec2 centre = { 0.0f, 0.0f }; ///< m, (x, z).
	float radius = 1.0f; ///< m, > 0 up to MOST_RADIUS.
	float falloff = 0.5f; ///< 0: the edge is hard; 1: it grows weaker from the middle on.

	/// How strong it is so far from its centre (m): 1 inside, 0 from the radius on.
	float weight(float distance) const;
};

/// What a brush does to the cells whose middles are in it.
struct DensityStroke {
	enum class Does {
		add, ///< Density more by `value`, -1 to 1. Below 0, plants/m² fall by the same part of what they are.
		approach, ///< Density goes to `value`, 0 to 1, and plants/m² to 0, by `strength` of the way.
		approach_plants, ///< Plants/m² go to `value`, and density to 0, by `strength` of the way.
		smooth, ///< Density, plants/m² and height go to the mean of the nine cells around, by `strength` of the way.
		set_height, ///< The height factor goes to `value`, by `strength` of the way.
	};

	Does does = Does::add;
	float value = 1.0f;
	float strength = 1.0f; ///< 0 to 1.
};

/// Whether all numbers are finite and in range, and the brush is within FARTHEST_COORDINATE.
bool is_valid(const DensityBrush &brush);

/// Tells which cells changed, which are around all that did. A weak stroke changes a cell by at least the least step
/// that there is, so that it arrives where it goes if it is repeated.
CellRange paint(DensityMap &map, int layer, const DensityBrush &brush, const DensityStroke &stroke);

/// Sets the density (0 to 1) of all cells whose middles are in a polygon, and their plants/m² to 0. Returns the cells
/// that changed. The polygon has no fault.
CellRange fill_polygon(DensityMap &map, int layer, const Polygon &polygon, float density);

/// Sets their plants/m² (0 to DensityCell::MAX_PLANT_DENSITY), and their density to 0.
CellRange fill_polygon_plants(DensityMap &map, int layer, const Polygon &polygon, float plants);

/// 0 to 1 in steps of 1/255.
uint8_t density_code(float share);
/// In steps of 1/64, from DensityCell::LEAST_HEIGHT.
uint8_t height_code(float factor);
/// Of plants/m², 0 to DensityCell::MAX_PLANT_DENSITY.
uint16_t plants_code(float plants);

} // namespace undergrowth

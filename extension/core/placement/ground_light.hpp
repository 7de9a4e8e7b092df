#pragma once

#include "placement/habitat_raster.hpp"
#include "placement/height_grid.hpp"

#include <glm/vec3.hpp>

#include <array>
#include <vector>

namespace undergrowth {

/// Number of directions in which a horizon is known, evenly around a point from +x towards +z.
inline constexpr int HORIZON_DIRECTIONS = 16;

/// Heights of the horizon around a point: tangents of angles above the horizontal, 0 or more.
using Horizon = std::array<double, HORIZON_DIRECTIONS>;

/// The horizon of a point of the grid, by the ground of the grid.
Horizon find_horizon(const HeightGrid &grid, int column, int row);

/// Directions to the sun (unit vectors) through a day of the equinox, at equal times from sunrise to sunset.
/// `latitude`: rad, -π/2 to π/2, positive in the north. North is -z, east +x.
std::vector<glm::dvec3> sun_path(double latitude);

/// Light from 0 to 1: 0.5 on level open ground, more on slopes towards the sun, less in the shade of slopes and hills.
/// 70 % is from the sun along sun_path(), 30 % from the visible sky. Points without ground have 0.5.
HabitatRaster find_light(const HeightGrid &grid, double latitude);

} // namespace undergrowth

#pragma once

#include "placement/habitat_raster.hpp"
#include "placement/height_grid.hpp"

#include <vector>

namespace undergrowth {

/// Area (m²) that drains through each point of a grid, its own square included. Water flows to all lower neighbours, by
/// slope; pits are filled to their outlet first (priority flood). It leaves the grid at its border and beside points
/// without ground, which have 0.
std::vector<double> find_drained_areas(const HeightGrid &grid);

/// Moisture from 0 (dry) to 1 (wet): a tenth of the topographic wetness index ln(a / tan β), of the drained area per
/// width a (m) and the slope β, at least MIN_SLOPE. Pits are 1, points without ground 0. It does not depend on the rest
/// of the grid except through the drained area.
HabitatRaster find_moisture(const HeightGrid &grid);

/// m/m. Flatter ground drains as this one.
inline constexpr double MIN_DRAINING_SLOPE = 0.01;
inline constexpr double WETTEST_INDEX = 10.0;

} // namespace undergrowth

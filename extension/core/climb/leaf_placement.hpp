#pragma once

#include "climb/climb_growth.hpp"
#include "climb/surface_grid.hpp"

namespace undergrowth {

/// Adds the leaves of all shoots: on both sides in turn, smaller and lighter towards the tips, pointing down as far as
/// the surface allows. A leaf that would reach into a support is turned aside, or left out where no side is free.
void place_leaves(const SurfaceGrid &grid, const ClimbSettings &settings, Climb &climb);

} // namespace undergrowth

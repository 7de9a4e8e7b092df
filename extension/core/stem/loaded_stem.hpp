#pragma once

#include "stem/stem_constants.hpp"
#include "wind/precipitation.hpp"

namespace undergrowth {

/// kg/m² of drag area, on a wet plant: a film of 0.1 mm on both sides of leaves at random angles.
constexpr float WATER_PER_DRAG_AREA = 0.4f;
/// kg/m² of drag area, on a plant full of snow: 20 mm of 100 kg/m³ on everything that is seen from above.
constexpr float SNOW_PER_DRAG_AREA = 2.0f;
/// Factor of the drag area of a plant full of snow: the snow is as high as most leaves are wide. Water adds none.
constexpr float SNOW_DRAG = 2.0f;

/// Clamps both numbers and rounds them to steps of 1/64, so that constants change rarely. A number that is not finite
/// becomes 0. Without rain, which is no load.
Precipitation rounded(const Precipitation &precipitation);

/// The same stem with the mass and drag area of water and snow, which are distributed like its drag area. It swings
/// more slowly, and snow catches more wind. Its shapes are the same.
StemConstants loaded_stem(const StemConstants &stem, const Precipitation &load);

/// Linear slope of the tip of a level stem under the weight of water and snow. That weight acts on a level stem as the
/// wind whose squared speed is the weight over the air's force at 1 m/s.
float slope_of_load(const StemConstants &stem, const Precipitation &load);

} // namespace undergrowth

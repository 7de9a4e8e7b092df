#pragma once

#include "stand/plants.hpp"

#include <cstdint>

namespace undergrowth {

/// What names a plant for as long as it stands, and again after it was filled anew: never negative. A plant that was
/// filled is named by its cell (Placement) and a mark of the placement's spacing, so that the same density gives the
/// same names whatever else changes, and two densities side by side none that are the same; one that was added by a
/// number of its own.
using PlantId = int64_t;

inline constexpr PlantId NO_PLANT = -1;

/// Of the plant with this root (m), filled at `spacing` (m, > 0).
PlantId filled_plant_id(float x, float z, double spacing);
/// Whether plants that were filled at `spacing` (m) have names like this one.
bool is_named_at(PlantId id, double spacing);
/// Whether two spacings have one mark, by chance of 1 to 4,095: plants of both are not to stand side by side.
bool share_names(double spacing, double other);
/// Of the plant that was added as number `number` (>= 0).
PlantId added_plant_id(int64_t number);
bool is_added(PlantId id);
/// Of a plant that was added.
int64_t added_plant_number(PlantId id);
/// The cell of a plant that was filled.
void filled_plant_cell(PlantId id, int &column, int &row);
/// A place (m) within the cell of a plant that was filled: its x and z are less than the spacing away.
void filled_plant_place(PlantId id, double spacing, float &x, float &z);

} // namespace undergrowth

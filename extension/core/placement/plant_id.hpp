#pragma once

#include "placement/plants.hpp"

#include <cstdint>

namespace undergrowth {

/// Identifies a plant while it exists, and again after a rebuild. Never negative. The id of a generated plant consists
/// of its cell (Placement) and a hash of the placement's spacing: the same density gives the same ids, and two
/// densities share none. The id of an added plant is a number of its own.
using PlantId = int64_t;

inline constexpr PlantId NO_PLANT = -1;

/// Id of the generated plant with this root (m), placed at `spacing` (m, > 0).
PlantId generated_plant_id(float x, float z, double spacing);
/// True if plants placed at `spacing` (m) have ids of this form.
bool matches_spacing(PlantId id, double spacing);
/// True if two spacings have the same hash (chance 1 : 4,095). Plants of both must not exist at the same time.
bool share_ids(double spacing, double other);
/// Id of the added plant `number` (>= 0).
PlantId added_plant_id(int64_t number);
bool is_added(PlantId id);
/// Number of an added plant.
int64_t added_plant_number(PlantId id);
/// Cell of a generated plant.
void generated_plant_cell(PlantId id, int &column, int &row);
/// A position (m) within the cell of a generated plant, less than the spacing from its root along x and z.
void generated_plant_position(PlantId id, double spacing, float &x, float &z);

} // namespace undergrowth

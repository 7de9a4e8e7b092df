#pragma once

#include <glm/vec3.hpp>

#include <cstdint>

namespace undergrowth {

/// m² that a mesh covers from the side, the mean over eight sides; what lies behind other parts counts once. Drawn on
/// four pictures of 256 by 256 dots, for opposite sides see the same outline. `reach` and `height`: m, how far the mesh
/// goes from its axis and from the ground up; what lies beyond is not seen.
float silhouette_area(const glm::vec3 *positions, const int32_t *indices, int index_count, float reach, float height);

} // namespace undergrowth

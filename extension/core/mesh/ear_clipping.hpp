#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Triangulates a simple ring, convex or not, into ring.size() - 2 triangles: three indices each, counter-clockwise
/// from above. Uses every point and every edge of the ring. Collinear points give triangles without area. Usually
/// O(n²), at worst O(n³).
std::vector<int32_t> clip_ears(const std::vector<glm::vec2> &ring);

} // namespace undergrowth

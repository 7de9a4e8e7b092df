#pragma once

#include <glm/vec2.hpp>

namespace undergrowth {

/// What remains of a field near its edges. Noise makes the border irregular.
struct EdgeFalloff {
	float density = 1.0f; ///< 0 to 1, chance that a plant remains.
	float height = 1.0f; ///< Factor of heights, LOWEST to 1.

	static constexpr double LOWEST = 0.25;
};

/// The falloff at a point `distance` (m) from the nearest edge, where it is `reach` (m, > 0) wide. From `reach` on it
/// changes nothing. It depends only on the point, so that fields in one place share it.
EdgeFalloff edge_falloff_at(const glm::vec2 &point, double distance, double reach);

} // namespace undergrowth

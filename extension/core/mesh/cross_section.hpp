#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// A ring with all that its meshes share, worked out once per species and level of detail.
struct CrossSection {
	std::vector<glm::vec2> points; ///< (x, z), counter-clockwise from above (conventions.hpp).
	std::vector<glm::vec2> normals; ///< Outward, unit length: the mean of the two edges at each point.
	std::vector<float> reach; ///< dot(points[i], normals[i]): how far the surface leans out as the ring widens.
	std::vector<int32_t> cap; ///< 3·(n - 2) indices that fill the ring, counter-clockwise from above.
	float radius = 0.0f; ///< Largest distance of a point from the origin.
};

/// Works out a valid ring (see find_ring_fault), convex or not. Caps are cut by ear clipping.
CrossSection make_cross_section(const std::vector<glm::vec2> &ring);

/// The outward unit normal of a ring's edge; zero where the edge has no length.
glm::vec2 edge_normal(glm::vec2 from, glm::vec2 to);

/// Writes the `count` outward unit normals of a ring's points: the mean of the two edges at each.
void ring_normals(const glm::vec2 *points, int count, glm::vec2 *normals);

} // namespace undergrowth

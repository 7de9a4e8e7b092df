#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// A ring with the data that all its meshes share, computed once per species and level of detail.
struct CrossSection {
	std::vector<glm::vec2> points; ///< (x, z), counter-clockwise from above (conventions.hpp).
	std::vector<glm::vec2> normals; ///< Outward, unit length: the mean of the two edges at each point.
	std::vector<float> reach; ///< dot(points[i], normals[i]): outward motion of the surface per unit of width.
	std::vector<int32_t> cap; ///< 3·(n - 2) indices that fill the ring, counter-clockwise from above.
	float radius = 0.0f; ///< Largest distance of a point from the origin.
};

/// Computes the data of a valid ring (see find_ring_fault), convex or not. Ear clipping triangulates the caps.
CrossSection make_cross_section(const std::vector<glm::vec2> &ring);

/// Returns the outward unit normal of a ring's edge; zero for an edge without length.
glm::vec2 edge_normal(glm::vec2 from, glm::vec2 to);

/// Writes the `count` outward unit normals of a ring's points: the mean of the two edges at each.
void ring_normals(const glm::vec2 *points, int count, glm::vec2 *normals);

} // namespace undergrowth

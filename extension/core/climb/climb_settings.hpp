#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace undergrowth {

/// The surfaces that a climbing plant grows on: triangles of either winding, in the axes of the plant.
struct ClimbSupport {
	std::vector<glm::vec3> corners; ///< m, three per triangle.
	std::vector<int> bodies; ///< Number of the body of each triangle. Empty: all belong to body 0.

	int triangles() const { return static_cast<int>(corners.size() / 3); }
	int body_of(int triangle) const { return bodies.empty() ? 0 : bodies[static_cast<std::size_t>(triangle)]; }
};

/// How a climbing plant grows.
struct ClimbSettings {
	uint64_t seed = 0;
	glm::vec3 root = { 0.0f, 0.0f, 0.0f }; ///< m.
	std::vector<glm::vec3> path; ///< m, points that the main shoots follow one after the other; empty: none.
	int shoots = 3; ///< Main shoots from the root, 1 to 64.
	float length = 4.0f; ///< m, of a main shoot, 0.05 to 200.
	float branching = 4.0f; ///< Branches per metre of a shoot, 0 to 20.
	float branch_length = 0.6f; ///< Of what is left of the parent at the fork, 0 to 1.
	float stem_spacing = 0.12f; ///< m, between branches; a branch ends where others are closer. 0.02 to 5.
	float leaf_spacing = 0.04f; ///< m, between leaves along a shoot, 0.005 to 5.
	float leaf_reach = 0.08f; ///< m, from the stem to the tip of a full-grown leaf, 0.002 to 5.
	glm::vec3 light = { 0.0f, 1.0f, 0.0f }; ///< Direction to the light, of any length; 0: none.
	glm::vec3 down = { 0.0f, -1.0f, 0.0f }; ///< Unit, direction of gravity.
	float light_weight = 0.35f; ///< 0 to 10.
	float gravity_weight = 1.0f; ///< 0 to 10: how strongly shoots without a support sag.
	float random_weight = 0.6f; ///< 0 to 10.
	float adhesion_distance = 0.25f; ///< m, at which a surface attracts a shoot, 0.01 to 5.
	float max_hanging = 0.6f; ///< m, of a shoot that leaves its support; then it ends. 0 to 20.
	float stem_diameter = 0.012f; ///< m, of a main shoot at the root, 0.001 to 0.5.
};

/// Why nothing can grow with these settings and the remedy, in one sentence that begins with the property; empty if
/// they are valid.
std::string find_climb_fault(const ClimbSettings &settings);

/// The same for triangles: their numbers, and whether there are any.
std::string find_support_fault(const ClimbSupport &support);

} // namespace undergrowth

#pragma once

#include "climb/climb_settings.hpp"

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace undergrowth {

/// A point on a shoot.
struct ClimbPoint {
	glm::vec3 place = { 0.0f, 0.0f, 0.0f }; ///< m, of the stem's axis.
	glm::vec3 normal = { 0.0f, 1.0f, 0.0f }; ///< Unit, away from the surface. Where the shoot hangs: the last one.
	float radius = 0.001f; ///< m.
	float to_tip = 0.0f; ///< m, along the shoot.
	int body = 0; ///< Of the support that carries it, or carried it last.
	bool is_attached = true;
};

/// A shoot: a line of points. A branch begins at a point of its parent.
struct ClimbShoot {
	int first = 0; ///< Its points are first … first + count - 1.
	int count = 0;
	int order = 0; ///< 0: from the root.
	uint64_t seed = 0;
};

/// A leaf on its stalk. Its axes: along `out` away from the surface, and along `down` to its tip.
struct ClimbLeaf {
	glm::vec3 place = { 0.0f, 0.0f, 0.0f }; ///< m, where the stalk leaves the stem.
	glm::vec3 out = { 0.0f, 1.0f, 0.0f }; ///< Unit.
	glm::vec3 down = { 0.0f, 0.0f, 1.0f }; ///< Unit, perpendicular to `out`.
	float size = 1.0f; ///< Relative to a full-grown leaf.
	float age = 1.0f; ///< 0: unfolds at the tip, 1: full-grown.
	float phase = 0.0f; ///< 0 to 1.
	int body = 0; ///< As ClimbPoint::body.
};

/// A grown climbing plant: flat lists.
struct Climb {
	std::vector<ClimbPoint> points;
	std::vector<ClimbShoot> shoots;
	std::vector<ClimbLeaf> leaves;
	float total_length = 0.0f; ///< m, of all shoots.
};

inline constexpr int MAX_CLIMB_POINTS = 400000;
inline constexpr int MAX_CLIMB_LEAVES = 200000;

/// Grows a plant over its support, after Luft, "An Ivy Generator" (2007). Each step of a shoot adds its own direction,
/// light, chance, the path and, without support, gravity. Where a surface is within the adhesion distance the shoot
/// approaches it and continues along it: over edges by the nearest point, in corners by the surface that it meets.
/// Returns what is wrong and what to do, and then grows nothing; empty for success. Any thread. Equal arguments give
/// equal bytes on every platform.
std::string grow_climb(const ClimbSupport &support, const ClimbSettings &settings, Climb &into);

} // namespace undergrowth

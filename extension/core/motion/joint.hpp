#pragma once

#include "conventions.hpp"
#include "plant/motion.hpp"

#include <glm/vec3.hpp>

namespace undergrowth {

/// One plant's joint: the root fixed, the tip at distance `length` and free to turn (thesis, section 3.2).
struct Joint {
	float length = 1.0f; ///< m, > 0.
	float mass = 1.0f; ///< kg, > 0.
	float wind_weight = 1.0f;
	float drag_area = -1.0f; ///< m², of air, its coefficient included; below 0: from wind_weight.
	// Elasticity law.
	float elasticity = 4.0f; ///< > -1.
	float inner_friction = 0.3f; ///< N·s/m, >= 0.
	bool above_ground = true; ///< Stops the tip at the ground plane. The thesis's joint has no ground: false.
	// Spring law.
	float natural_frequency = 1.0f; ///< Hz, > 0.
	float damping_ratio = 0.1f; ///< >= 0; 1 is critical.
	glm::vec3 rest = { 0.0f, 1.0f, 0.0f }; ///< Unit, in world axes, y > 0.
};

/// Motion of a tip, in world axes.
struct TipState {
	glm::vec3 direction = { 0.0f, 1.0f, 0.0f }; ///< Unit, root to tip.
	glm::vec3 rate = { 0.0f, 0.0f, 0.0f }; ///< 1/s, tangent to the sphere; times length it is the tip's velocity.
};

} // namespace undergrowth

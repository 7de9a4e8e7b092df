#pragma once

namespace undergrowth {

/// How a plant returns to its rest direction.
enum class Law {
	elasticity, ///< The thesis's (formulas 3.1 and 3.2): an upward force that grows with the tip's height.
	spring, ///< A damped spring at the joint that always returns to the rest direction.
	stem, ///< An elastic stem that bends along its length (stem/stem_beam.hpp).
};

/// What a species says about its motion. Each law uses its own part.
struct Motion {
	Law law = Law::spring;
	float elasticity = 4.0f; ///< Elasticity law; above 0 upright is stable, ω² = e·g/L.
	float inner_friction = 0.3f; ///< Elasticity law, N·s/m against the tip's velocity.
	float natural_frequency = 1.0f; ///< Spring and stem laws, Hz, of a small free swing of the finished plant.
	float damping_ratio = 0.1f; ///< Of both, 1 is critical.
	float mass = 1.0f; ///< kg, at the tip.
	/// Share of the wind's force that the plant catches; below 0: a tip all of it, a stem as much as bends it as far as
	/// a kilogram at the tip that swings as fast.
	float wind_weight = 1.0f;
	float drag_area = -1.0f; ///< m², of air, its coefficient included; below 0: as many as wind_weight.
	float lean = 0.0f; ///< Not of the elasticity law, rad from upright to the rest direction, below π/2.
	float collision_radius = 0.05f; ///< m, of the sphere at the tip.
};

} // namespace undergrowth

#pragma once

namespace undergrowth {

/// How a plant returns to its rest direction.
enum class Law {
	elasticity, ///< The thesis's (formulas 3.1 and 3.2): an upward force that grows with the tip's height.
	spring, ///< A damped spring at the joint that always returns to the rest direction.
	stem, ///< An elastic stem that bends along its length (stem/stem_beam.hpp).
};

/// Motion parameters of a species. Each law uses some of them.
struct Motion {
	Law law = Law::spring;
	float elasticity = 4.0f; ///< Elasticity law; above 0 upright is stable, ω² = e·g/L.
	float inner_friction = 0.3f; ///< Elasticity law, N·s/m against the tip's velocity.
	float natural_frequency = 1.0f; ///< Spring and stem laws, Hz, of a small free swing of the finished plant.
	float damping_ratio = 0.1f; ///< Of both, 1 is critical.
	float frequency_height = 0.0f; ///< Stem law: m, height of plants with natural_frequency; 0: all heights.
	float frequency_deviation = 0.0f; ///< Stem law: standard deviation at one height, as a fraction.
	float mass = 1.0f; ///< kg, at the tip.
	/// Fraction of the wind force that acts on the plant. Below 0: 1 for a tip; for a stem the value with which it
	/// bends as far as a kilogram at the tip of the same frequency.
	float wind_weight = 1.0f;
	float drag_area = -1.0f; ///< m², drag coefficient included; below 0: from wind_weight.
	float lean = 0.0f; ///< Spring and stem laws: rad from upright to the rest direction, below π/2.
	float collision_radius = 0.05f; ///< m, of the sphere at the tip.
	float trampling = 0.0f; ///< Stem law: part of a bend under a body that lasts (Trampling in motion/).
	float recovery_time = 300.0f; ///< Stem law, s.
	float lodging_angle = 0.0f; ///< Stem law, rad, below π: of the tip, beyond which a bend lasts; 0: none.
};

} // namespace undergrowth

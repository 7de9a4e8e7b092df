#pragma once

#include "motion/columns.hpp"
#include "motion/joint.hpp"
#include "motion/kernel_tables.hpp"
#include "base/simd.hpp"

namespace undergrowth {

/// All plants of one law that feel the same wind, in struct-of-arrays, stepped together by a fixed step.
///
/// Elasticity law (thesis, formulas 3.1 and 3.2): the tip feels (1 + e)·m·g·|y| upwards, m·g downwards, the wind and
/// -friction·velocity, held on the sphere: equilibrium under a horizontal force F is F·w = m·g·tan φ·((1 + e)·cos φ -
/// 1). Both norms are kept by an exact rotation; kicks are scaled (by sinc²(ω·step/2) without friction) so that a small
/// swing has exactly ω² = e·g/L and friction's decay at any step length up to a third of its period; stiffer joints
/// swing at about that period and stay stable. The rate is that of the middle of the last step (kick, then drift).
///
/// Spring law: the state is the gnomonic image t = (x, z)/y of the direction, which obeys
/// t'' = -ω²·(t - rest - F·w/(m·ω²·L)) - 2·ζ·ω·t'. The step is the closed-form solution for a force that is constant
/// during it, so there is no step-length error, nothing can become unstable, and the tip never reaches the ground.
/// The equilibrium of an upright plant under a horizontal force F is tan φ = F·w/(m·ω²·L). A vertical force has no
/// effect.
///
/// Numbers out of a joint's or a state's range are brought to the nearest safe one; nothing becomes NaN.
///
/// Indices are dense: removing one moves the last plant into its place. Adding may allocate, stepping never does.
/// Steps on disjoint ranges may run on several threads at once and give the same bits as one call.
class PendulumBatch {
public:
	/// `step` in seconds, finite and > 0.
	PendulumBatch(Law law, float step);

	Law law() const;
	float step_length() const;
	int size() const;

	/// Adds a plant and tells its index, which is the former size().
	int add(const Joint &joint, const TipState &state);
	/// Removes plant `index`. The plant that was last now has this index (nothing moved if `index` was last).
	void remove(int index);

	/// Changes a plant's constants; its motion goes on.
	void set_joint(int index, const Joint &joint);
	TipState state(int index) const;
	/// Puts a plant into a state, without a trace of the last one.
	void set_state(int index, const TipState &state);
	/// A blow on the tip (N·s): changes the velocity by impulse/mass, along the sphere.
	void apply_impulse(int index, const glm::vec3 &impulse);

	/// One step of plants [begin, end) under the force `wind` (N). `level` chooses the code, not the result.
	void step(int begin, int end, const glm::vec3 &wind, SimdLevel level);
	void step(const glm::vec3 &wind);

	/// Unit directions of all plants, `alpha` of the way from the last step but one (0) to the last (1), to out[0 ..
	/// size()).
	void interpolate(float alpha, glm::vec3 *out) const;

private:
	Law batch_law;
	float step_time; ///< s.
	Columns columns;

	ElasticityTable elasticity_table();
	SpringTable spring_table();
	void set_elasticity_state(int index, const TipState &state);
	void set_spring_state(int index, const TipState &state);
};

} // namespace undergrowth

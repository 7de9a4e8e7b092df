#pragma once

#include "base/simd.hpp"
#include "wind/wind_kernels.hpp"

#include <cstdint>

namespace undergrowth {

/// Directions now and one step ago.
struct DirectionView {
	const float *x, *y, *z;
	const float *last_x, *last_y, *last_z;
};

/// t now and one step ago.
struct GnomonicView {
	const float *x, *z;
	const float *last_x, *last_z;
};

/// Plants of one species under the elasticity law. They differ in length only, so that most constants are the species'
/// own: one array entry per plant, and one number for all.
struct ElasticityPage {
	float *x, *y, *z; ///< Direction.
	/// What the last step turned the direction by, stretched by sqrt(1 + its square); on the tangent plane it is the
	/// rate times the step.
	float *turn_x, *turn_y, *turn_z;
	const float *weight; ///< g/L·gain·step.
	float lift_share; ///< 1 + e: lift over weight.
	float wind_share; ///< w/(m·g): the wind's gain, w/(m·L)·gain·step, over weight, 1/N.
	float keep; ///< Share of the rate that friction leaves in one step.
	float lowest_y; ///< Where the ground stops the tip; far below -1 for no ground.
};

/// The same for the spring law. t = (x, z)/y is the gnomonic image of the direction.
struct SpringPage {
	float *x, *z; ///< t.
	float *rate_x, *rate_z; ///< t', 1/s.
	const float *rest_x, *rest_z; ///< t of the rest direction.
	const float *wind_gain; ///< w/(m·ω²·L), 1/N.
	float place_from_place; ///< The closed-form step less the identity, for (t - equilibrium, t').
	float place_from_rate; ///< s.
	float rate_from_place; ///< 1/s.
	float rate_from_rate;
	float most; ///< MAX_GNOMONIC.
};

/// Air (m/s) at each plant, and what it does to the tip: with the speed s of the air past it, a force of drag·s times
/// the air's velocity (on a wind weight of 1), and drag·s times the tip's own against that.
struct PlantAir {
	const float *x, *z;
	const float *lengths; ///< m.
	float drag; ///< kg/m.
	float slowing; ///< What the second force takes of the rate in a step, over s, s/m.
	float steps; ///< In a second.
};

/// Both laws keep t and its equilibrium within this size, so that nothing overflows: 0.06 degrees above the ground.
inline constexpr float MAX_GNOMONIC = 1e3f;

/// One build of the kernels. All builds give the same bits for any split of a range.
struct KernelSet {
	void (*step_elasticity)(const ElasticityPage &page, int count, const PlantWinds &winds);
	void (*step_spring)(const SpringPage &page, int count, const PlantWinds &winds);
	void (*step_elasticity_in_air)(const ElasticityPage &page, int count, const PlantAir &air);
	void (*step_spring_in_air)(const SpringPage &page, int count, const PlantAir &air);
	/// Moves each pair of bends (motion/bend_encoding.hpp) on: the second becomes the first, the present one the
	/// second.
	void (*encode_elasticity)(const float *x, const float *y, const float *z, int count, uint32_t *pairs);
	void (*encode_spring)(const float *x, const float *z, int count, uint32_t *pairs);
	/// Unit directions to out[0 .. 3·count), three floats each.
	void (*interpolate_elasticity)(const DirectionView &view, int count, float alpha, float *out);
	void (*interpolate_spring)(const GnomonicView &view, int count, float alpha, float *out);
};

const KernelSet *baseline_kernel_set();
/// Null where this build has none.
const KernelSet *avx2_kernel_set();

/// The kernels of `level`, or the baseline where this processor or build has no such level.
const KernelSet &kernels(SimdLevel level);

} // namespace undergrowth

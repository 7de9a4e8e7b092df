#pragma once

#include "pendulum/kernels.hpp"

namespace undergrowth {

/// What the elasticity kernel reads and writes: one array entry per plant.
struct ElasticityTable {
	float *x, *y, *z; ///< Direction.
	/// What the last step turned the direction by, stretched by sqrt(1 + its square); on the tangent plane it is the
	/// rate times the step.
	float *turn_x, *turn_y, *turn_z;
	float *last_x, *last_y, *last_z; ///< Direction one step ago.
	const float *lift; ///< (1 + e)·g/L·gain·step.
	const float *weight; ///< g/L·gain·step.
	const float *wind_gain; ///< w/(m·L)·gain·step, 1/N.
	const float *keep; ///< Share of the rate that friction leaves in one step.
	const float *lowest_y; ///< Where the ground stops the tip; far below -1 for no ground.
};

/// What the spring kernel reads and writes. t = (x, z)/y is the gnomonic image of the direction.
struct SpringTable {
	float *x, *z; ///< t.
	float *rate_x, *rate_z; ///< t', 1/s.
	float *last_x, *last_z; ///< t one step ago.
	const float *rest_x, *rest_z; ///< t of the rest direction.
	const float *wind_gain; ///< w/(m·ω²·L), 1/N.
	const float *place_from_place; ///< The closed-form step less the identity, for (t - equilibrium, t').
	const float *place_from_rate; ///< s.
	const float *rate_from_place; ///< 1/s.
	const float *rate_from_rate;
};

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

/// The force of one step (N).
struct KernelWind {
	float x, y, z;
	float size;
};

/// Both laws keep t and its equilibrium within this size, so that nothing overflows: 0.06 degrees above the ground.
inline constexpr float MAX_GNOMONIC = 1e3f;

/// One build of the kernels. All builds give the same bits for any split of a range.
struct KernelSet {
	void (*step_elasticity)(const ElasticityTable &table, int begin, int end, const KernelWind &wind);
	void (*step_spring)(const SpringTable &table, int begin, int end, float most, const KernelWind &wind);
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

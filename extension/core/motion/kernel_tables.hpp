#pragma once

#include "base/simd.hpp"
#include "stem/stem_constants.hpp"
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
	/// Rotation of the last step, scaled by sqrt(1 + its square); on the tangent plane it is the rate times the step.
	float *turn_x, *turn_y, *turn_z;
	const float *weight; ///< g/L·gain·step.
	float lift_share; ///< 1 + e: lift over weight.
	float wind_share; ///< w/(m·g): the wind's gain, w/(m·L)·gain·step, over weight, 1/N.
	float keep; ///< Fraction of the rate that remains after friction in one step.
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
	float max; ///< MAX_GNOMONIC.
};

/// Both laws clamp t and its equilibrium to this size, so that nothing overflows: 0.06 degrees above the ground.
inline constexpr float MAX_GNOMONIC = 1e3f;

/// Air (m/s) at each plant, in the axes of the directions, or null; and its drag on a tip of the laws of one joint. At
/// the relative speed s the force is drag·s times the air's velocity (for a wind weight of 1), minus drag·s times the
/// tip's.
struct PlantAir {
	const float *x = nullptr;
	const float *y = nullptr; ///< Upward; null: level air. The laws of one joint do not use it.
	const float *z = nullptr;
	const float *lengths = nullptr; ///< m.
	float drag = 0.0f; ///< kg/m.
	float slowing = 0.0f; ///< Fraction of the rate that the second force removes in a step, over s, s/m.
	float steps = 0.0f; ///< Per second.
};

/// Coefficients of the step of one mode of a stem (StemMode), for one step length.
struct StemModeStep {
	/// The closed-form step as in SpringPage; for a mode that is too fast, a step to its equilibrium.
	float place_from_place, place_from_rate, rate_from_place, rate_from_rate;
	float dead_share, air_share; ///< Half of StemMode's.
	float air_drag; ///< s/m: fraction of the rate that the air removes in a step at 1 m/s of wind.
	float air_lag; ///< m, as in StemMode.
};

/// The tip's bend in the middle of a step, or a little later, of the first mode at its start.
struct StemTip {
	float of_place;
	float of_rate; ///< s.
	float max = 1.0f; ///< The horizon.
};

/// Constants of a species' stems for one step length. Some are variables for the same reason as in bounded().
struct StemStep {
	int modes;
	StemModeStep mode[MAX_STEM_MODES];
	float tip_slope[MAX_STEM_MODES]; ///< As in StemMode.
	float chord[MAX_STEM_MODES]; ///< The same; 0 where there is no ground.
	float second_share; ///< In a steady wind, the second mode's amplitude over that of the first.
	StemTip dead_tip, air_tip; ///< Under a load of either kind.
	float dead_slope, air_slope; ///< As in StemConstants.
	StemAlong dead_along, air_along; ///< The same.
	StemNod nod; ///< Its share is twice that of StemConstants.
	float max_force; ///< N: `max_load` over `dead_slope`.
	float softness; ///< 1 over the load, as linear slope of the tip, that a step can follow.
	float max_place = MAX_STEM_AMPLITUDE;
	float max_load = 1e4f; ///< Linear slope of the tip: 0.006 degrees from along the wind.
	float max_wind = 150.0f; ///< m/s.
	float min_hold = 1e-3f; ///< Of 1 and the load along the stem.
	float max_eased = 2.0f; ///< Linear slope of the tip up to which StemAlong::ease holds for air that comes down.
	float one = 1.0f;
};

/// Plants of one species under the stem law.
struct StemPage {
	float *x[MAX_STEM_MODES], *z[MAX_STEM_MODES]; ///< Amplitudes in the frame of the rest direction.
	float *rate_x[MAX_STEM_MODES], *rate_z[MAX_STEM_MODES]; ///< 1/s.
	const float *rest_x, *rest_z; ///< Stereographic image of the rest direction (motion/bend_encoding.hpp).
	const float *scale; ///< The length that the species' constants are for, over the plant's own.
	/// Only for stems with own frequencies, else null: factors of `scale` for both kinds of load, and per
	/// plant the first four members of StemModeStep of each mode.
	const float *dead_ease, *air_ease;
	const float *by_height[MAX_STEM_MODES][4];
	float max_scale; ///< Upper bound of `scale`, graded or not; a tight bound makes steps faster.
	float max_lean; ///< Upper bound of the rest's bends; 0 selects a faster step with the same bits.
	StemStep step;
};

/// Weight of water and snow on the stems of a species, besides their own (StemNod).
struct StemWeight {
	float slope = 0.0f; ///< Linear slope of the tip of a level stem of the species' length (slope_of_load()).
	/// Direction in which the weight acts, relative to that of the tip: StemConstants::axial_share.
	float along = 1.0f;
	float max_half = 1.0f; ///< rad: half of the maximum bend. Variables for the same reason as in bounded().
	float min_square = 1e-12f;

	bool is_none() const { return slope == 0.0f; }
};

/// Bends of tips, in the frame of the rest, that stems return to in calm air. `share`: of each mode's amplitude.
struct CalmBends {
	float *x, *z;
	float share[MAX_STEM_MODES];
};

/// Bends at places along the stems of a species, as sums of four factors that stem_factors() finds for each plant: both
/// amplitudes, and the third and fifth power of the tip's bend. Three bends (Gauss) give the centre of a place.
struct StemCurve {
	static constexpr int PLACES = 8; ///< Evenly spaced, without the root.
	float value[3][4][PLACES]; ///< By quadrature point and factor.
	float weight[3][PLACES]; ///< Of the quadrature, times the place.
	float tip_slope[MAX_STEM_MODES]; ///< 0 for a second mode that does not exist.
};

/// The core of a body (motion/bodies.hpp). Inverses are 0 if the edge has no length.
struct BodyCore {
	float from[3]; ///< m.
	float way[3]; ///< m, to the other end of the middle line.
	float inverse; ///< 1/m², of the squared way.
	float half[2][3]; ///< m: half of the other two edges.
	float half_inverse[2]; ///< 1/m².
	float one = 1.0f; ///< A variable for the same reason as in bounded().
	bool is_box;
};

/// Stems near a body, in columns.
struct NearStems {
	static constexpr int MAX = 64;
	float x[MAX_STEM_MODES][MAX], z[MAX_STEM_MODES][MAX]; ///< Amplitudes; 0 for a second mode that does not exist.
	float rest_x[MAX], rest_z[MAX];
	float root_x[MAX], root_y[MAX], root_z[MAX]; ///< m.
	float length[MAX], half[MAX]; ///< m; `half`: upper bound of half the length, for find_near_stems().
};

/// One build of the kernels. All builds give the same bits for any split of a range.
struct KernelSet {
	void (*step_elasticity)(const ElasticityPage &page, int count, const PlantWinds &winds);
	void (*step_spring)(const SpringPage &page, int count, const PlantWinds &winds);
	void (*step_elasticity_in_air)(const ElasticityPage &page, int count, const PlantAir &air);
	void (*step_spring_in_air)(const SpringPage &page, int count, const PlantAir &air);
	/// `winds` (N) and `air` (m/s) act together. Either one's arrays may be null.
	void (*step_stem)(const StemPage &page, int count, const PlantWinds &winds, const PlantAir &air);
	/// Brings stems whose tips are below the ground up to it; step_stem() does it as well.
	void (*lift_stems)(const StemPage &page, int count);
	/// Writes bends of tips to which the weight would bring stems, in the frame of their rest, for the step that begins
	/// now, from the first mode alone (StemTip).
	///
	/// The weight bends a stem by slope·sin θ, where θ is the angle from upright of a place about halfway. So the
	/// weight also makes stems softer, and lays them over if it is greater than their buckling load. It acts on plants
	/// that wind or bodies bend as well. No weight bends a stem by more than 2 rad, so that steps of any length
	/// converge.
	///
	/// No stem is exactly straight: for the weight each one leans by up to 0.15 rad more along x and along z, by its
	/// root (m), in the frame of the rest. A plant at the origin does not.
	void (*weigh_stems)(const StemPage &page, const float *root_x, const float *root_z, int count,
			const StemWeight &weight, float *x, float *z);
	/// Adds to a step what these bends change: a mode's step is linear in its distance from the equilibrium.
	void (*move_calm)(const StemPage &page, int count, const CalmBends &calm);
	/// Writes for each stem which of its halves may be in a body: 1 for the lower, 2 for the upper. With the distances
	/// a and b of its ends from the core, a piece of a stem is at least (a + b - length) / 2 away. `reach`: twice the
	/// body's radius (m).
	void (*find_near_stems)(const StemCurve &curve, const BodyCore &core, float reach, const NearStems &stems,
			int count, int32_t *halves);
	/// Writes the squared distances of a stem's places from a core that is relative to the root, in the frame of the
	/// rest. x, z: amplitudes of both modes.
	void (*measure_stem)(
			const StemCurve &curve, const BodyCore &core, const float *x, const float *z, float length, float *squares);
	/// Shifts each pair of bends (motion/bend_encoding.hpp): the second becomes the first, the present one the second.
	void (*encode_elasticity)(const float *x, const float *y, const float *z, int count, uint32_t *pairs);
	void (*encode_spring)(const float *x, const float *z, int count, uint32_t *pairs);
	/// The tip's bends (motion/stem_state.hpp, StemBends); `second_pairs` is unused with one mode.
	void (*encode_stem)(const StemPage &page, int count, uint32_t *pairs, uint32_t *second_pairs);
	/// Unit directions to out[0 .. 3·count), three floats each.
	void (*interpolate_elasticity)(const DirectionView &view, int count, float alpha, float *out);
	void (*interpolate_spring)(const GnomonicView &view, int count, float alpha, float *out);
};

const KernelSet *baseline_kernel_set();
/// Null if this build has none.
const KernelSet *avx2_kernel_set();

/// The kernels of `level`, or the baseline if this processor or build lacks that level.
const KernelSet &kernels(SimdLevel level);

} // namespace undergrowth

#pragma once

#include "motion/kernel_tables.hpp"

namespace undergrowth {

/// Weight of water and snow on the stems of a species. Without it they rest as their species says, since a rest
/// direction contains the bend under a stem's own weight.
struct StemWeight {
	float slope = 0.0f; ///< Linear slope of the tip of a level stem of the species' length (slope_of_load()).
	/// Direction in which the weight acts, relative to that of the tip: StemConstants::axial_share.
	float along = 1.0f;

	bool is_none() const { return slope == 0.0f; }
};

/// Bends of tips to which the weight would bring stems, in the frame of their rest, for the step that begins now, from
/// the first mode alone (StemTip). The modes divide them as in a steady wind.
///
/// The weight bends a stem by slope·sin θ, where θ is the angle from upright of a place about halfway. So the weight
/// also makes stems softer, and lays them over if it is greater than their buckling load. It acts on plants that wind
/// or bodies bend as well. Beyond the horizon it does not grow further, so that steps of any length converge.
///
/// No stem is exactly straight: for the weight each one leans by up to 0.15 rad more along x and along z, by its root
/// (m), in the frame of the rest. A plant at the origin does not.
void weigh_stems(const StemPage &page, const float *root_x, const float *root_z, int count, const StemWeight &weight,
		float *x, float *z);

} // namespace undergrowth

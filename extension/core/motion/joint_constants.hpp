#pragma once

#include "motion/joint.hpp"

namespace undergrowth {

/// What the elasticity kernel needs of one joint for one step length; units as in ElasticityTable.
struct ElasticityConstants {
	float lift;
	float weight;
	float wind_gain;
	float keep;
	float lowest_y;
};

/// What the spring kernel needs of one joint for one step length; units as in SpringTable.
struct SpringConstants {
	float rest_x;
	float rest_z;
	float wind_gain;
	float place_from_place;
	float place_from_rate;
	float rate_from_place;
	float rate_from_rate;
};

/// The joint with every number brought into the range that the steps are safe in (not a number becomes the default).
Joint safe_joint(const Joint &joint);

ElasticityConstants elasticity_constants(const Joint &joint, float step);
/// The `weight` of elasticity_constants() for joints like `joint` with each of `count` lengths (m); the same bits.
void elasticity_weights(const Joint &joint, float step, const float *lengths, int count, float *weights);
SpringConstants spring_constants(const Joint &joint, float step);

} // namespace undergrowth

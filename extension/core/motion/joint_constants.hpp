#pragma once

#include "motion/joint.hpp"

namespace undergrowth {

/// What the elasticity kernel needs of one species for one step length; units as in ElasticityPage.
struct ElasticityConstants {
	float lift_share;
	float wind_share;
	float keep;
	float lowest_y;
};

/// What the spring kernel needs of one species for one step length; units as in SpringPage, but `wind_gain` is for a
/// plant of one metre: over the length it is a plant's own.
struct SpringConstants {
	float wind_gain;
	float place_from_place;
	float place_from_rate;
	float rate_from_place;
	float rate_from_rate;
};

/// The joint with every number brought into the range that the steps are safe in (not a number becomes the default).
Joint safe_joint(const Joint &joint);

/// These take a safe joint and do not ask for its length.
ElasticityConstants elasticity_constants(const Joint &joint, float step);
SpringConstants spring_constants(const Joint &joint, float step);
/// ElasticityPage::weight of plants with each of `count` lengths (m).
void elasticity_weights(const Joint &joint, float step, const float *lengths, int count, float *weights);
/// SpringPage::wind_gain of them.
void spring_gains(const SpringConstants &constants, const float *lengths, int count, float *gains);
/// PlantAir::drag: half the air's density times the drag area, over the wind weight, by which steps multiply forces.
float air_drag(const Joint &joint);

} // namespace undergrowth

#pragma once

#include "motion/joint.hpp"

namespace undergrowth {

/// Constants of the elasticity kernel for one species and step length; units as in ElasticityPage.
struct ElasticityConstants {
	float lift_share;
	float wind_share;
	float keep;
	float lowest_y;
};

/// Constants of the spring kernel for one species and step length; units as in SpringPage. `wind_gain` is for a plant
/// of one metre; divide it by the length.
struct SpringConstants {
	float wind_gain;
	float place_from_place;
	float place_from_rate;
	float rate_from_place;
	float rate_from_rate;
};

/// The joint with all values clamped to the safe range of the steps. NaN becomes the default.
Joint safe_joint(const Joint &joint);

/// Both take a safe joint and ignore its length.
ElasticityConstants elasticity_constants(const Joint &joint, float step);
SpringConstants spring_constants(const Joint &joint, float step);
/// ElasticityPage::weight of plants with each of `count` lengths (m).
void elasticity_weights(const Joint &joint, float step, const float *lengths, int count, float *weights);
/// SpringPage::wind_gain of them.
void spring_gains(const SpringConstants &constants, const float *lengths, int count, float *gains);
/// PlantAir::drag: half the air's density times the drag area, over the wind weight, by which steps multiply forces.
float air_drag(const Joint &joint);

} // namespace undergrowth

#pragma once

#include "motion/kernel_tables.hpp"
#include "stem/stem_constants.hpp"

namespace undergrowth {

/// What the stem kernel needs of a species for steps of one length (s).
///
/// The modes' steps are the closed form of a damped oscillator, so frequency and damping are as they say at any step
/// length. A mode with less than four steps to a swing does not swing: it stands where its load leads.
/// `above_ground`: whether the ground stops tips.
StemStep stem_step_constants(const StemConstants &stem, float step, bool above_ground = true);

/// Columns of StemPage for stems whose frequencies follow from their height.
struct StemGrades {
	float *dead_ease, *air_ease;
	float *by_height[MOST_STEM_MODES][4];
};

/// Fills them in for plants with each of `count` lengths (m). Returns how much faster than the species' the fastest of
/// them swings, 1 at least.
float stem_grades(const StemConstants &stem, float step, const float *lengths, int count, const StemGrades &to);

/// StemPage::scale of plants with each of `count` lengths (m); 1 for those without one, who are gone.
void stem_scales(const StemConstants &stem, const float *lengths, int count, float *scales);

} // namespace undergrowth

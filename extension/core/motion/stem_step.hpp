#pragma once

#include "motion/kernel_tables.hpp"
#include "stem/stem_constants.hpp"

namespace undergrowth {

/// Constants of the stem kernel for a species and a step length (s).
///
/// The modes' steps are the closed form of a damped oscillator, so frequency and damping are exact at any step
/// length. A mode with less than four steps per period does not swing: it takes its equilibrium. `above_ground`: the
/// ground stops tips.
StemStep stem_step_constants(const StemConstants &stem, float step, bool above_ground = true);

/// What stems with own frequencies differ in, beside their length; as in MotionPlant.
struct OwnStem {
	float scale = 1.0f;
	float own = 0.0f;
};

/// Stems whose frequencies differ.
struct OwnStems {
	const float *lengths; ///< m.
	const OwnStem *stems;
	int count;
};

/// Columns of StemPage for them.
struct StemGrades {
	float *dead_ease, *air_ease;
	float *by_height[MAX_STEM_MODES][4];
};

/// Fills in the columns. If the own frequency of a plant differs from that of its size, its stiffness differs, and
/// loads bend it differently. Scaled plants have the same proportions; the change of gravity's effect is left out.
/// Returns the highest frequency relative to the species', at least 1.
float stem_grades(const StemConstants &stem, float step, const OwnStems &plants, const StemGrades &to);

/// StemPage::scale of plants with each of `count` lengths (m); 1 for removed plants (length 0).
void stem_scales(const StemConstants &stem, const float *lengths, int count, float *scales);

} // namespace undergrowth

#include "motion/stem_step.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"
#include "motion/joint_constants.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace undergrowth {

namespace {

constexpr float MIN_LENGTH = 1e-4f; // m.
constexpr float MAX_RATIO = 4.0f; // Of heights: far above those of a species' own plants.
constexpr float MIN_GRADE = 0.05f;
constexpr float MIN_SHARE = 1e-3f;
constexpr float MIN_SLOPE = 1e-30f; // 1/N.
/// rad per step, a quarter of a swing. The motion of faster modes would be an artefact of the step.
constexpr float MAX_PHASE = static_cast<float>(0.5 * PI);
/// A step settles up to twice this share of a load's projection at the current bend, times load·(ω_1·step)².
constexpr float FOLLOWED = 0.25f;

StemModeStep mode_step(const StemMode &mode, float step) {
	StemModeStep made;
	made.dead_share = 0.5f * mode.dead_share;
	made.air_share = 0.5f * mode.air_share;
	made.air_drag = step * mode.air_drag / mode.mass;
	made.air_lag = mode.air_lag;
	if (mode.frequency * step > MAX_PHASE) {
		made.place_from_place = -1.0f;
		made.place_from_rate = 0.0f;
		made.rate_from_place = 0.0f;
		made.rate_from_rate = -1.0f;
		return made;
	}
	Joint joint;
	joint.natural_frequency = static_cast<float>(static_cast<double>(mode.frequency) / (2.0 * PI));
	joint.damping_ratio = mode.damping;
	const SpringConstants spring = spring_constants(joint, step);
	made.place_from_place = spring.place_from_place;
	made.place_from_rate = spring.place_from_rate;
	made.rate_from_place = spring.rate_from_place;
	made.rate_from_rate = spring.rate_from_rate;
	return made;
}

/// Steps of a mode at frequencies that are rounded to 0.4 %, so that most plants of a page share one of a few hundred.
class ModeSteps {
public:
	/// Rounds a factor of the frequency to 8 bits behind the first.
	static float rounded(float relative) {
		uint32_t bits;
		std::memcpy(&bits, &relative, sizeof bits);
		bits = (bits + (1u << (SHIFT - 1))) & ~((1u << SHIFT) - 1);
		std::memcpy(&relative, &bits, sizeof bits);
		return relative;
	}
	/// Returns the step of `mode` at a rounded factor, > 0, of its frequency.
	const StemModeStep &of(const StemMode &mode, float relative, float step) {
		uint32_t bits;
		std::memcpy(&bits, &relative, sizeof bits);
		const uint32_t place = (bits >> SHIFT) % SIZE;
		if (relatives[place] != relative) {
			StemMode own = mode;
			own.frequency *= relative;
			relatives[place] = relative;
			steps[place] = mode_step(own, step);
		}
		return steps[place];
	}

private:
	static constexpr int SHIFT = 15; // Bits of a float that are rounded off.
	static constexpr uint32_t SIZE = 512; // Two octaves.
	float relatives[SIZE] = {};
	StemModeStep steps[SIZE]; // Valid where `relatives` is not 0.
};

/// Of a first mode with this share of the tip's bend.
StemTip tip_of(float share, float step) {
	StemTip tip;
	tip.of_place = 1.0f / std::max(share, MIN_SHARE);
	tip.of_rate = 0.5f * step * tip.of_place;
	return tip;
}

/// s: how far ahead of the start of a step loads in newtons are read. tan(ω·step/2)/ω, a little after the middle: the
/// Jacobian of a step of an undamped stem then has the determinant 1, for loads that depend on its bend in any way.
/// Such a stem neither gains nor loses energy. Read in the middle, it gains some. Plants with own frequencies use that
/// of the fastest ones; the others lose a little.
float lossless_rate(const StemConstants &stem, float step) {
	constexpr float FASTEST = 1.5f; // Of plants with own frequencies.
	const float frequency = stem.mode[0].frequency * (stem.has_own_frequencies() ? FASTEST : 1.0f);
	const double phase = std::min(frequency * step, MAX_PHASE);
	return static_cast<float>(portable_tan(0.5 * phase) / phase) * step;
}

} // namespace

StemStep stem_step_constants(const StemConstants &stem, float step, bool above_ground) {
	StemStep made = {};
	made.modes = std::clamp(stem.modes, 1, MAX_STEM_MODES);
	for (int k = 0; k < made.modes; k++) {
		made.mode[k] = mode_step(stem.mode[k], step);
		made.tip_slope[k] = stem.mode[k].tip_slope;
		made.chord[k] = above_ground ? stem.mode[k].chord : 0.0f;
	}
	made.second_share = made.modes == 2 ? stem.mode[1].dead_share / stem.mode[0].dead_share : 0.0f;
	const float phase = stem.mode[0].frequency * step;
	made.dead_slope = stem.dead_slope;
	made.air_slope = stem.air_slope;
	made.dead_along = stem.dead_along;
	made.air_along = stem.air_along;
	made.nod = { 2.0f * stem.nod.share, stem.nod.ease };
	made.dead_tip = tip_of(stem.mode[0].dead_share, step);
	made.dead_tip.of_rate = lossless_rate(stem, step) * made.dead_tip.of_place;
	made.air_tip = tip_of(stem.mode[0].air_share, step);
	made.max_force = made.max_load / std::max(made.dead_slope, MIN_SLOPE);
	made.softness = phase * phase / FOLLOWED;
	return made;
}

float stem_grades(const StemConstants &stem, float step, const OwnStems &plants, const StemGrades &to) {
	const bool is_by_length = stem.has_grades();
	ModeSteps known[MAX_STEM_MODES];
	float fastest = 1.0f;
	for (int i = 0; i < plants.count; i++) {
		const float length = plants.lengths[i];
		const bool is_graded = is_by_length && length > MIN_LENGTH;
		const float scale = is_graded ? plants.stems[i].scale : 1.0f;
		const float ratio = is_graded ? std::min(length / (scale * stem.length), MAX_RATIO) : 1.0f;
		const float pace = 1.0f + stem.spread * plants.stems[i].own;
		const float softness = ratio * scale / (pace * pace); // Times StemPage::scale it is 1 over the stiffness.
		to.dead_ease[i] = softness * std::max(stem.dead_grade.at(ratio), MIN_GRADE) / (scale * scale);
		to.air_ease[i] = softness * std::max(stem.air_grade.at(ratio), MIN_GRADE);
		for (int k = 0; k < stem.modes; k++) {
			const float period = scale * std::max(stem.mode[k].period.at(ratio), MIN_GRADE);
			const float relative = ModeSteps::rounded(pace / period);
			fastest = std::max(fastest, relative);
			const StemModeStep &made = known[k].of(stem.mode[k], relative, step);
			to.by_height[k][0][i] = made.place_from_place;
			to.by_height[k][1][i] = made.place_from_rate;
			to.by_height[k][2][i] = made.rate_from_place;
			to.by_height[k][3][i] = made.rate_from_rate;
		}
	}
	return fastest;
}

void stem_scales(const StemConstants &stem, const float *lengths, int count, float *scales) {
	for (int i = 0; i < count; i++) {
		scales[i] = lengths[i] > MIN_LENGTH ? stem.length / lengths[i] : 1.0f;
	}
}

} // namespace undergrowth

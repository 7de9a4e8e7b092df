#include "form/profile.hpp"

#include "base/portable_math.hpp"

#include <algorithm>

namespace undergrowth {

namespace {

constexpr float INSIDE = 0.01f; // Of the length: minimum distance from the ends at which slopes are evaluated.
// Leaves that narrow only at their end are blunt there, not pointed.
constexpr float BLUNT_FALL = 0.4f;
constexpr float BLUNT_END = 0.97f; // Of the length: from there on the width is constant.
constexpr int MEAN_STEPS = 32;

float profile_at(const Profile &profile, float widest, float s) {
	// If one exponent is negligible beside the other, the widest point rounds to an end.
	const double up =
			profile.rise > 0.0f && widest > 0.0f ? portable_pow(static_cast<double>(s) / widest, profile.rise) : 1.0;
	const double down =
			profile.fall > 0.0f && widest < 1.0f ? portable_pow((1.0 - s) / (1.0 - widest), profile.fall) : 1.0;
	return static_cast<float>(up * down);
}

float sample_at(const std::vector<float> &samples, float s) {
	const float place = s * static_cast<float>(samples.size() - 1);
	const size_t before = std::min(static_cast<size_t>(place), samples.size() - 2);
	const float t = place - static_cast<float>(before);
	return samples[before] * (1.0f - t) + samples[before + 1] * t;
}

} // namespace

float WidthFunction::widest() const {
	if (!samples.empty()) {
		const auto max = std::max_element(samples.begin(), samples.end());
		return static_cast<float>(max - samples.begin()) / static_cast<float>(samples.size() - 1);
	}
	const float sum = profile.rise + profile.fall;
	return sum > 0.0f ? profile.rise / sum : 0.0f;
}

bool WidthFunction::is_blunt() const {
	return samples.empty() && profile.fall <= BLUNT_FALL;
}

float WidthFunction::at(float s) const {
	if (!samples.empty()) {
		return sample_at(samples, s);
	}
	const float max = widest();
	const float width = profile_at(profile, max, is_blunt() ? std::min(s, BLUNT_END) : s);
	return s < max ? std::max(width, base_width) : width;
}

float WidthFunction::slope(float s) const {
	return slope(s, samples.empty() ? at(s) : 0.0f);
}

float WidthFunction::slope(float s, float width_there) const {
	const float inside = std::clamp(s, INSIDE, 1.0f - INSIDE);
	if (samples.empty()) {
		const float width = inside == s ? width_there : at(inside);
		const bool is_held = (inside < widest() && width == base_width) || (is_blunt() && inside > BLUNT_END);
		return is_held ? 0.0f : width * (profile.rise / inside - profile.fall / (1.0f - inside));
	}
	const float low = std::max(inside - INSIDE, 0.0f);
	const float high = std::min(inside + INSIDE, 1.0f);
	return (at(high) - at(low)) / (high - low);
}

float WidthFunction::mean() const {
	// s = 3t² - 2t³ concentrates the steps where roots are steep; the midpoint rule applies to it.
	double sum = 0.0;
	for (int i = 0; i < MEAN_STEPS; i++) {
		const double t = (i + 0.5) / MEAN_STEPS;
		sum += 6.0 * t * (1.0 - t) * at(static_cast<float>(t * t * (3.0 - 2.0 * t)));
	}
	return static_cast<float>(sum / MEAN_STEPS);
}

} // namespace undergrowth

#include "placement/edge_falloff.hpp"

#include "placement/cell_noise.hpp"

#include <algorithm>

namespace undergrowth {

namespace {

/// Sizes of bays and tongues of the border, in reaches, and the share of the small ones.
constexpr double BAY = 2.0;
constexpr double TONGUE = 0.5;
constexpr double TONGUES = 0.4;
/// Part of the reach in which noise moves the border. The rest is the slope from none to all.
constexpr double SWAY = 0.5;
/// Noise from -1 to 1 is mostly near 0.
constexpr double NOISE_GAIN = 0.9;

} // namespace

EdgeFalloff edge_falloff_at(const glm::vec2 &point, double distance, double reach) {
	if (distance >= reach) {
		return {};
	}
	const double x = static_cast<double>(point.x) / reach;
	const double z = static_cast<double>(point.y) / reach;
	const double bays = smooth_noise(x / BAY, z / BAY);
	const double tongues = smooth_noise(x / TONGUE, z / TONGUE);
	const double noise = std::clamp(0.5 + NOISE_GAIN * ((1.0 - TONGUES) * bays + TONGUES * tongues), 0.0, 1.0);
	const double share = std::clamp((distance / reach - SWAY * noise) / (1.0 - SWAY), 0.0, 1.0);
	EdgeFalloff falloff;
	falloff.density = static_cast<float>(share * (2.0 - share)); // Low plants remain nearer to the edge than tall ones.
	falloff.height = static_cast<float>(EdgeFalloff::LOWEST + (1.0 - EdgeFalloff::LOWEST) * share);
	return falloff;
}

} // namespace undergrowth

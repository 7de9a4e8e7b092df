#include "mesh/openness.hpp"

#include "base/portable_math.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace undergrowth {

namespace {

// Light in a canopy decreases exponentially with the leaf area above (Beer-Lambert).
constexpr double EXTINCTION = 1.6; // From the top of a plant to the ground, where a fifth remains.
constexpr float INNER_SHADE = 0.4f; // Fraction of the light in the middle of a clump.

} // namespace

Openness::Openness(const PlantForm &form) : height(form.height), reach(form.reach) {
	static const auto falls = [] { // The same for all plants.
		std::array<float, HEIGHTS + 2> at;
		for (size_t i = 0; i < at.size(); i++) {
			const double below = std::max(0.0, 1.0 - static_cast<double>(i) / HEIGHTS);
			at[i] = static_cast<float>(portable_exp(-EXTINCTION * below));
		}
		return at;
	}();
	std::copy(falls.begin(), falls.end(), light);
}

float Openness::at(const glm::vec3 &point) const {
	const float place = std::clamp(point.y / height, 0.0f, 1.0f) * HEIGHTS;
	const int below = static_cast<int>(place);
	const float t = place - static_cast<float>(below);
	const float above_it = light[below] * (1.0f - t) + light[below + 1] * t;
	const float away = std::sqrt(point.x * point.x + point.z * point.z);
	const float inside = reach > 0.0f ? std::max(0.0f, 1.0f - away / reach) : 0.0f;
	return above_it * (1.0f - INNER_SHADE * inside * inside);
}

} // namespace undergrowth

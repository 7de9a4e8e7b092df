#include "motion/gnomonic.hpp"

#include "motion/kernel_tables.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float MAX_RATE = 1e4f; // 1/s; a tip that circles 1,600 times a second.

bool is_finite(const glm::vec3 &vector) {
	return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

/// `vector` shortened to `max`, without overflow.
glm::vec3 shortened(const glm::vec3 &vector, float max) {
	const float largest = std::max({ std::fabs(vector.x), std::fabs(vector.y), std::fabs(vector.z) });
	if (largest <= 0.0f) {
		return vector;
	}
	const glm::vec3 scaled = vector / largest;
	const float size = std::sqrt(glm::dot(scaled, scaled));
	return largest > max / size ? scaled * (max / size) : vector;
}

} // namespace

TipState safe_state(const TipState &state) {
	const TipState upright;
	TipState safe;
	const float squared = glm::dot(state.direction, state.direction);
	const bool usable = is_finite(state.direction) && squared > 1e-12f && std::isfinite(squared);
	safe.direction = usable ? state.direction / std::sqrt(squared) : upright.direction;
	const glm::vec3 rate = is_finite(state.rate) ? shortened(state.rate, MAX_RATE) : upright.rate;
	safe.rate = rate - glm::dot(rate, safe.direction) * safe.direction;
	return safe;
}

GnomonicState to_gnomonic(const TipState &state) {
	constexpr float LOWEST_Y = 1.0f / MAX_GNOMONIC;
	const TipState safe = safe_state(state);
	const glm::vec3 &d = safe.direction;
	const float y = std::max(d.y, LOWEST_Y);
	GnomonicState flat;
	flat.x = std::clamp(d.x / y, -MAX_GNOMONIC, MAX_GNOMONIC);
	flat.z = std::clamp(d.z / y, -MAX_GNOMONIC, MAX_GNOMONIC);
	flat.rate_x = (safe.rate.x - flat.x * safe.rate.y) / y;
	flat.rate_z = (safe.rate.z - flat.z * safe.rate.y) / y;
	return flat;
}

TipState from_gnomonic(const GnomonicState &state) {
	const float scale = 1.0f / std::sqrt(state.x * state.x + state.z * state.z + 1.0f);
	TipState tip;
	tip.direction = glm::vec3(state.x, 1.0f, state.z) * scale;
	const glm::vec3 rate = glm::vec3(state.rate_x, 0.0f, state.rate_z) * scale;
	tip.rate = rate - glm::dot(rate, tip.direction) * tip.direction;
	return tip;
}

} // namespace undergrowth

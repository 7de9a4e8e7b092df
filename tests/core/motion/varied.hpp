#pragma once

#include "swing.hpp"

#include "base/random.hpp"
#include "wind/field_wind.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

/// Plants that are all different, for the tests of pages.
namespace undergrowth {

inline constexpr Law BOTH_LAWS[] = { Law::elasticity, Law::spring };
inline constexpr float STATE_TOLERANCE = 1e-6f;

inline float noise(int index, int which) {
	return signed_noise(static_cast<uint64_t>(which), static_cast<uint64_t>(index));
}

inline MotionPlant varied_plant(int index) {
	MotionPlant plant;
	plant.root = { 20.0f * noise(index, 14), 0.0f, 20.0f * noise(index, 15) };
	plant.length = 1.0f + 0.8f * noise(index, 1);
	plant.rest = glm::normalize(glm::vec3(0.5f * noise(index, 7), 1.0f, 0.5f * noise(index, 8)));
	return plant;
}

inline Joint varied_joint(int index) {
	Joint joint;
	joint.mass = 0.6f + 0.5f * noise(index, 2);
	joint.elasticity = 5.0f + 4.0f * noise(index, 3);
	joint.inner_friction = 0.3f + 0.3f * noise(index, 4);
	joint.above_ground = index % 3 != 0;
	joint.natural_frequency = 1.5f + noise(index, 5);
	joint.damping_ratio = 0.8f + 0.8f * noise(index, 6);
	return joint;
}

inline TipState varied_state(int index) {
	return { { noise(index, 9), 1.0f, noise(index, 10) }, { noise(index, 11), noise(index, 12), noise(index, 13) } };
}

/// Plants [first, first + count), each in its own state, of one species.
inline MotionPage meadow(Law law, int first, int count, MotionPage::Keeps keeps = MotionPage::Keeps::directions) {
	std::vector<MotionPlant> plants;
	for (int i = 0; i < count; i++) {
		plants.push_back(varied_plant(first + i));
	}
	MotionPage page(0, species_with(law, varied_joint(1)), plants.data(), count, FRAME_STEP, true, keeps);
	for (int i = 0; i < count; i++) {
		page.set_state(i, varied_state(first + i));
	}
	return page;
}

inline void apply_wind(MotionPage &page, int step, SimdLevel level = best_simd_level()) {
	FieldWind wind;
	wind.wind.kind = WindKind::waves;
	wind.wind.strength = 2.0f;
	wind.wind.direction = 0.9f;
	page.step(wind_at_time(wind, step * static_cast<double>(FRAME_STEP)), winds_along(wind), level);
}

inline bool same_bits(const TipState &a, const TipState &b) {
	return std::memcmp(&a, &b, sizeof a) == 0;
}

inline bool is_finite(const TipState &state) {
	return std::isfinite(state.direction.x + state.direction.y + state.direction.z) &&
			std::isfinite(state.rate.x + state.rate.y + state.rate.z);
}

} // namespace undergrowth

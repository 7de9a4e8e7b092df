#include "motion/stem_impulses.hpp"

#include "stem/stem_bones.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float MIN_EASE = 1e-12f; // 1/kg, m/N.

struct Deflection {
	float of_mode[MAX_STEM_MODES];
};

/// φ of the modes (m).
Deflection deflection_at(const StemConstants &stem, float x) {
	Deflection found = {};
	const float at = std::clamp(x, 0.0f, 1.0f) * static_cast<float>(stem.joints);
	const int below = std::min(static_cast<int>(at), stem.joints - 1);
	const float share = at - static_cast<float>(below);
	for (int k = 0; k < stem.modes; k++) {
		const float from = below == 0 ? 0.0f : stem.deflection[below - 1][k];
		found.of_mode[k] = from + share * (stem.deflection[below][k] - from);
		found.of_mode[k] = x > 1.0f ? stem.deflection[stem.joints][k] : found.of_mode[k];
	}
	return found;
}

glm::vec2 bend_at(const StemConstants &stem, const StemState &state, float x) {
	return stem_bend(stem, state.place, std::min(x, 1.0f));
}

/// Effect of a vector on the bend u, times its n = 1 + |u|²: the part of the vector that is across the stem there.
glm::vec2 across_stem(const glm::vec3 &vector, const glm::vec2 &bend) {
	const glm::vec2 level(vector.x, vector.z);
	return (1.0f + glm::dot(bend, bend)) * level - 2.0f * (glm::dot(bend, level) + vector.y) * bend;
}

} // namespace

glm::vec3 stem_velocity(const StemConstants &stem, const StemState &state, float x, float scale) {
	const Deflection deflection = deflection_at(stem, x);
	glm::vec2 rate(0.0f);
	for (int k = 0; k < stem.modes; k++) {
		rate += 2.0f * deflection.of_mode[k] / scale * state.rate[k];
	}
	const glm::vec2 bend = bend_at(stem, state, x);
	const float inverse = 1.0f / (1.0f + glm::dot(bend, bend));
	// Velocity of a direction from the rate of its bend.
	const float growth = 2.0f * inverse * glm::dot(bend, rate);
	const glm::vec2 level = inverse * (rate - growth * bend);
	return { level.x, -inverse * growth, level.y };
}

float stem_mass(const StemConstants &stem, float x) {
	const Deflection deflection = deflection_at(stem, x);
	float ease = 0.0f;
	for (int k = 0; k < stem.modes; k++) {
		ease += deflection.of_mode[k] * deflection.of_mode[k] / stem.mode[k].mass;
	}
	return 1.0f / std::max(ease, MIN_EASE);
}

void apply_stem_impulse(const StemConstants &stem, StemState &state, float x, const glm::vec3 &impulse, float scale) {
	const Deflection deflection = deflection_at(stem, x);
	const glm::vec2 across = across_stem(impulse, bend_at(stem, state, x));
	for (int k = 0; k < stem.modes; k++) {
		state.rate[k] += scale * deflection.of_mode[k] / (2.0f * stem.mode[k].mass) * across;
	}
	state = safe_stem(stem, state);
}

void push_stem(const StemConstants &stem, StemState &state, float x, const glm::vec3 &way, float scale) {
	const Deflection deflection = deflection_at(stem, x);
	float ease = 0.0f;
	for (int k = 0; k < stem.modes; k++) {
		ease += deflection.of_mode[k] * deflection.of_mode[k] / stem.mode[k].stiffness;
	}
	const glm::vec2 moved = across_stem(way, bend_at(stem, state, x)) * (scale / std::max(2.0f * ease, MIN_EASE));
	for (int k = 0; k < stem.modes; k++) {
		state.place[k] += deflection.of_mode[k] / stem.mode[k].stiffness * moved;
	}
	state = safe_stem(stem, state);
}

} // namespace undergrowth

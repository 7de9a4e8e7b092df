#include "motion/stem_impulses.hpp"

#include "stem/stem_bones.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float MIN_EASE = 1e-12f; // 1/kg, m/N.

glm::vec2 bend_at(const StemConstants &stem, const StemState &state, float x) {
	return stem_bend(stem, state.place, std::min(x, 1.0f));
}

/// Effect of a vector on the bend u, times its n = 1 + |u|²: the part of the vector that is across the stem there.
glm::vec2 across_stem(const glm::vec3 &vector, const glm::vec2 &bend) {
	const glm::vec2 level(vector.x, vector.z);
	return (1.0f + glm::dot(bend, bend)) * level - 2.0f * (glm::dot(bend, level) + vector.y) * bend;
}

} // namespace

StemPoint stem_point(const StemConstants &stem, float x) {
	StemPoint point = {};
	const float at = std::clamp(x, 0.0f, 1.0f) * static_cast<float>(stem.joints);
	const int below = std::min(static_cast<int>(at), stem.joints - 1);
	const float share = at - static_cast<float>(below);
	float give = 0.0f;
	float ease = 0.0f;
	for (int k = 0; k < stem.modes; k++) {
		const float from = below == 0 ? 0.0f : stem.deflection[below - 1][k];
		const float between = from + share * (stem.deflection[below][k] - from);
		const float deflection = x > 1.0f ? stem.deflection[stem.joints][k] : between;
		give += deflection * deflection / stem.mode[k].stiffness;
		ease += deflection * deflection / stem.mode[k].mass;
		point.deflection[k] = deflection;
	}
	point.give = std::max(2.0f * give, MIN_EASE);
	point.mass = 1.0f / std::max(ease, MIN_EASE);
	return point;
}

glm::vec3 stem_velocity(
		const StemConstants &stem, const StemState &state, const StemPoint &point, const glm::vec2 &bend, float scale) {
	glm::vec2 rate(0.0f);
	for (int k = 0; k < stem.modes; k++) {
		rate += 2.0f * point.deflection[k] / scale * state.rate[k];
	}
	const float inverse = 1.0f / (1.0f + glm::dot(bend, bend));
	// Velocity of a direction from the rate of its bend.
	const float growth = 2.0f * inverse * glm::dot(bend, rate);
	const glm::vec2 level = inverse * (rate - growth * bend);
	return { level.x, -inverse * growth, level.y };
}

void apply_stem_impulse(const StemConstants &stem, StemState &state, const StemPoint &point, const glm::vec2 &bend,
		const glm::vec3 &impulse, float scale) {
	const glm::vec2 across = across_stem(impulse, bend);
	for (int k = 0; k < stem.modes; k++) {
		state.rate[k] += scale * point.deflection[k] / (2.0f * stem.mode[k].mass) * across;
	}
	state = safe_stem(stem, state);
}

void push_stem(const StemConstants &stem, StemState &state, const StemPoint &point, const glm::vec2 &bend,
		const glm::vec3 &way, float scale) {
	const glm::vec2 moved = across_stem(way, bend) * (scale / point.give);
	for (int k = 0; k < stem.modes; k++) {
		state.place[k] += point.deflection[k] / stem.mode[k].stiffness * moved;
	}
	state = safe_stem(stem, state);
}

glm::vec3 stem_velocity(const StemConstants &stem, const StemState &state, float x, float scale) {
	return stem_velocity(stem, state, stem_point(stem, x), bend_at(stem, state, x), scale);
}

float stem_mass(const StemConstants &stem, float x) {
	return stem_point(stem, x).mass;
}

void apply_stem_impulse(const StemConstants &stem, StemState &state, float x, const glm::vec3 &impulse, float scale) {
	apply_stem_impulse(stem, state, stem_point(stem, x), bend_at(stem, state, x), impulse, scale);
}

void push_stem(const StemConstants &stem, StemState &state, float x, const glm::vec3 &way, float scale) {
	push_stem(stem, state, stem_point(stem, x), bend_at(stem, state, x), way, scale);
}

} // namespace undergrowth

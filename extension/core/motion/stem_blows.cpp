#include "motion/stem_blows.hpp"

#include "stem/stem_bones.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

/// φ of each mode at a joint.
const float *deflections(const StemConstants &stem, int joint) {
	return stem.deflection[std::clamp(joint, 1, stem.joints + 1) - 1];
}

glm::vec2 bend_at(const StemConstants &stem, const glm::vec2 *places, int joint) {
	return stem_bend(stem, places, std::min(static_cast<float>(joint) / static_cast<float>(stem.joints), 1.0f));
}

/// What `vector` is for amplitudes: its part across the stem, which counts the more the farther that is bent.
glm::vec2 for_amplitudes(const glm::vec3 &vector, const glm::vec2 &bend) {
	const glm::vec2 across = { vector.x, vector.z };
	return (1.0f + glm::dot(bend, bend)) * across - 2.0f * bend * (glm::dot(bend, across) + vector.y);
}

/// `vector`, or where it is longer than `most` as long. Without size where it is no number.
glm::vec2 no_longer(const glm::vec2 &vector, float most) {
	const float largest = std::max(std::fabs(vector.x), std::fabs(vector.y));
	if (!std::isfinite(vector.x) || !std::isfinite(vector.y) || largest <= 0.0f) {
		return { 0.0f, 0.0f };
	}
	const float size = largest * glm::length(vector / largest);
	return size > most ? vector * (most / size) : vector;
}

} // namespace

float mass_at_joint(const StemConstants &stem, int joint) {
	const float *shape = deflections(stem, joint);
	float ease = 0.0f;
	for (int k = 0; k < stem.modes; k++) {
		ease += shape[k] * shape[k] / stem.mode[k].mass;
	}
	return 1.0f / ease;
}

glm::vec3 velocity_of_joint(
		const StemConstants &stem, const glm::vec2 *places, const glm::vec2 *rates, int joint, float scale) {
	const float *shape = deflections(stem, joint);
	const glm::vec2 bend = bend_at(stem, places, joint);
	const float turn = 2.0f / (1.0f + glm::dot(bend, bend));
	glm::vec2 across = { 0.0f, 0.0f };
	for (int k = 0; k < stem.modes; k++) {
		across += rates[k] * (shape[k] * turn / scale);
	}
	const float inward = turn * glm::dot(bend, across);
	return { across.x - bend.x * inward, -inward, across.y - bend.y * inward };
}

void strike_stem(const StemConstants &stem, const glm::vec2 *places, glm::vec2 *rates, int joint,
		const glm::vec3 &impulse, float scale) {
	const float *shape = deflections(stem, joint);
	const glm::vec2 across = for_amplitudes(impulse, bend_at(stem, places, joint));
	for (int k = 0; k < stem.modes; k++) {
		const StemMode &mode = stem.mode[k];
		rates[k] =
				no_longer(rates[k] + across * (0.5f * scale * shape[k] / mode.mass), MOST_BLOWN_RATE * mode.frequency);
	}
}

void push_stem(const StemConstants &stem, glm::vec2 *places, int joint, const glm::vec3 &way, float scale) {
	const float *shape = deflections(stem, joint);
	const glm::vec2 across = for_amplitudes(way, bend_at(stem, places, joint));
	float ease = 0.0f;
	for (int k = 0; k < stem.modes; k++) {
		ease += shape[k] * shape[k] / stem.mode[k].stiffness;
	}
	for (int k = 0; k < stem.modes; k++) {
		const float share = 0.5f * scale * shape[k] / (stem.mode[k].stiffness * ease);
		places[k] = no_longer(places[k] + across * share, MOST_PUSHED_PLACE);
	}
}

} // namespace undergrowth

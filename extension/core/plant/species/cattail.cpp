#include "plant/species/cattail.hpp"

#include "plant/base_shape.hpp"

#include <glm/common.hpp>

namespace undergrowth {

namespace {

constexpr float HEAD_START = 0.68f;
constexpr float HEAD_END = 0.9f;

/// 1 within the head, 0 outside of it.
float head(float offset) {
	return glm::smoothstep(HEAD_START - 0.02f, HEAD_START + 0.02f, offset) *
			(1.0f - glm::smoothstep(HEAD_END - 0.02f, HEAD_END + 0.02f, offset));
}

} // namespace

std::vector<glm::vec2> Cattail::base_shape(int lod) const {
	return circle_ring(lod, stem_radius);
}

float Cattail::width(float offset) const {
	const float stem = 1.5f - 0.8f * glm::smoothstep(0.0f, 0.6f, offset);
	const float spike = 0.8f * (1.0f - offset) / (1.0f - HEAD_END);
	return glm::mix(glm::min(stem, spike), 2.9f, head(offset));
}

glm::vec4 Cattail::color(float offset) const {
	const glm::vec4 rest = offset < 0.5f * (HEAD_START + HEAD_END) ? stem_color : spike_color;
	return glm::mix(rest, head_color, head(offset));
}

Motion Cattail::motion() {
	Motion motion;
	motion.elasticity = 12.0f;
	motion.inner_friction = 0.3f;
	motion.natural_frequency = 0.8f;
	motion.damping_ratio = 0.08f;
	motion.mass = 0.5f;
	motion.wind_weight = 0.6f;
	motion.collision_radius = 0.04f;
	return motion;
}

} // namespace undergrowth

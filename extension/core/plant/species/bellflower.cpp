#include "plant/species/bellflower.hpp"

#include "conventions.hpp"
#include "plant/base_shape.hpp"

#include <glm/common.hpp>

namespace undergrowth {

namespace {

constexpr float BELL_START = 0.79f;

} // namespace

std::vector<glm::vec2> Bellflower::base_shape(int lod) const {
	return lobed_ring(lod, bell_radius, 5, 0.2);
}

float Bellflower::width(float offset) const {
	if (offset < BELL_START) {
		return 0.13f - 0.05f * offset;
	}
	// A round shoulder, then walls that flare towards the rim.
	const float t = (offset - BELL_START) / (1.0f - BELL_START);
	return 0.09f + 0.6f * glm::smoothstep(0.0f, 0.4f, t) + 0.31f * t * t * t * t;
}

glm::vec4 Bellflower::color(float offset) const {
	const glm::vec4 bell = glm::mix(bell_color, rim_color, glm::smoothstep(BELL_START + 0.05f, 1.0f, offset));
	return glm::mix(stem_color, bell, glm::smoothstep(BELL_START, BELL_START + 0.05f, offset));
}

Motion Bellflower::motion() {
	Motion motion;
	motion.elasticity = 0.2f;
	motion.inner_friction = 0.08f;
	motion.natural_frequency = 1.4f;
	motion.damping_ratio = 0.1f;
	motion.mass = 0.2f;
	motion.wind_weight = 0.3f;
	motion.lean = float(42 / 180.0 * PI);
	motion.collision_radius = 0.07f;
	return motion;
}

} // namespace undergrowth

#include "plant/species/reed.hpp"

#include "conventions.hpp"
#include "plant/base_shape.hpp"

#include <glm/common.hpp>

namespace undergrowth {

namespace {

constexpr float PLUME_START = 0.7f;
constexpr float JOINTS = 5.0f; // Between the ground and the plume.
constexpr float TUFTS = 3.0f;

/// 1 at a joint of the stem, 0 halfway between two.
float joint(float offset) {
	const float place = offset / PLUME_START * JOINTS;
	const float distance = glm::abs(glm::fract(place) - 0.5f);
	return glm::smoothstep(0.2f, 0.5f, distance);
}

/// The plume's tufts: 1 where one spreads, 0 where the next begins.
float tuft(float t) {
	const float place = glm::fract(t * TUFTS + 0.75f);
	return 1.0f - 4.0f * (place - 0.5f) * (place - 0.5f);
}

} // namespace

std::vector<glm::vec2> Reed::base_shape(int lod) const {
	return circle_ring(lod, stem_radius);
}

float Reed::width(float offset) const {
	if (offset < PLUME_START) {
		return 1.15f - 0.6f * offset + 0.3f * joint(offset);
	}
	const float t = (offset - PLUME_START) / (1.0f - PLUME_START);
	const float outline = 3.6f * glm::smoothstep(0.0f, 0.5f, t) * (1.0f - t * t);
	return (0.73f + outline) * (1.0f - 0.75f * t * t * t) * (0.45f + 0.6f * tuft(t));
}

glm::vec4 Reed::color(float offset) const {
	const glm::vec4 stem = glm::mix(stem_color, joint_color, 0.8f * joint(offset));
	const float t = (offset - PLUME_START) / (1.0f - PLUME_START);
	const glm::vec4 plume = glm::mix(plume_color, plume_tip_color, 0.55f * tuft(t) + 0.35f * t);
	return glm::mix(stem, plume, glm::smoothstep(PLUME_START - 0.02f, PLUME_START + 0.06f, offset));
}

Motion Reed::motion() {
	Motion motion;
	motion.elasticity = 8.0f;
	motion.inner_friction = 0.2f;
	motion.natural_frequency = 0.7f;
	motion.damping_ratio = 0.06f;
	motion.mass = 0.4f;
	motion.wind_weight = 0.6f;
	motion.lean = float(3.5 / 180.0 * PI);
	motion.collision_radius = 0.06f;
	return motion;
}

} // namespace undergrowth

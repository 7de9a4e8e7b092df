#include "plant/species/grass.hpp"

#include "conventions.hpp"
#include "plant/base_shape.hpp"

#include <glm/common.hpp>

namespace undergrowth {

std::vector<glm::vec2> Grass::base_shape(int) const {
	return parallelogram_ring(blade_width, 0.16f * blade_width, 0.45f * blade_width);
}

float Grass::width(float offset) const {
	// 0.6 at the ground, 1 at a third of the height, 0 at the tip.
	const float rest = 1.0f - offset;
	return rest * (0.6f + 2.0f * offset + 0.3f * offset * offset) * 0.99f;
}

glm::vec4 Grass::color(float offset) const {
	const glm::vec4 lower = glm::mix(root_color, middle_color, glm::smoothstep(0.0f, 0.55f, offset));
	return glm::mix(lower, tip_color, glm::smoothstep(0.5f, 1.0f, offset));
}

Motion Grass::motion() {
	Motion motion;
	motion.elasticity = 3.0f;
	motion.inner_friction = 0.06f;
	motion.natural_frequency = 2.0f;
	motion.damping_ratio = 0.12f;
	motion.mass = 0.05f;
	motion.wind_weight = 0.2f;
	motion.lean = float(14 / 180.0 * PI);
	motion.collision_radius = 0.02f;
	return motion;
}

} // namespace undergrowth

#include "plant/species/tulip.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"
#include "plant/base_shape.hpp"

namespace undergrowth {

namespace {

constexpr float FLOWER_START = 0.75f;

} // namespace

std::vector<glm::vec2> Tulip::base_shape(int lod) const {
	return circle_ring(lod);
}

float Tulip::width(float offset) const {
	if (offset < FLOWER_START) {
		return 0.1f;
	}
	const double flower_offset = (static_cast<double>(offset) - FLOWER_START) / 0.3 * PI;
	return static_cast<float>(0.5 + portable_sin(flower_offset) / 3.0);
}

glm::vec4 Tulip::color(float offset) const {
	return offset < FLOWER_START ? stem_color : flower_color;
}

Motion Tulip::motion() {
	Motion motion;
	motion.elasticity = 6.0f;
	motion.inner_friction = 0.25f;
	motion.natural_frequency = 1.1f;
	motion.damping_ratio = 0.09f;
	motion.mass = 0.3f;
	motion.wind_weight = 0.5f;
	motion.collision_radius = 0.2f;
	return motion;
}

} // namespace undergrowth

#include "motion/motion_species.hpp"

#include "base/random.hpp"

#include <cmath>

namespace undergrowth {

namespace {

bool is_finite(const glm::vec3 &vector) {
	return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

} // namespace

bool is_same_motion(const MotionSpecies &a, const MotionSpecies &b) {
	const Joint &one = a.joint;
	const Joint &other = b.joint;
	return a.law == b.law && one.mass == other.mass && one.wind_weight == other.wind_weight &&
			one.drag_area == other.drag_area && a.canopy_height == b.canopy_height &&
			one.elasticity == other.elasticity && one.inner_friction == other.inner_friction &&
			one.above_ground == other.above_ground && one.natural_frequency == other.natural_frequency &&
			one.damping_ratio == other.damping_ratio && a.collision_radius == b.collision_radius &&
			a.trampling == b.trampling && (a.law != Law::stem || a.stem == b.stem);
}

bool has_same_drag(const MotionSpecies &a, const MotionSpecies &b) {
	return a.law == b.law && a.canopy_height == b.canopy_height && a.joint.drag_area == b.joint.drag_area &&
			a.stem.drag_area == b.stem.drag_area;
}

float own_of_root(const glm::vec3 &root) {
	return signed_unit(bits_of_place(0, root.x, root.z));
}

bool is_valid(const MotionPlant &plant) {
	return std::fabs(plant.own) <= 1.0f && std::isfinite(plant.scale) && plant.scale > 0.0f && is_finite(plant.root) &&
			std::isfinite(plant.length) && plant.length > 0.0f && is_finite(plant.rest) && plant.rest.y > 0.0f;
}

} // namespace undergrowth

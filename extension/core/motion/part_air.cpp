#include "motion/part_air.hpp"

#include "motion/joint_constants.hpp"
#include "wind/air_sources.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

/// Newtons of a wind over the square of the speed of the air that bends the species as far.
float newtons_of_air(const MotionSpecies &species) {
	if (species.law != Law::stem) {
		return air_drag(species.joint);
	}
	return species.stem.dead_slope > 0.0f ? species.stem.air_slope / species.stem.dead_slope : 0.0f;
}

} // namespace

float air_speed_at(const WindSnapshot &wind, const PlantWinds &along, const MotionSpecies &species,
		const TallerPlants &taller, float length, const glm::vec3 &root) {
	float x = 0.0f;
	float z = 0.0f;
	if (wind.is_air) {
		const AirMoments moments = moments_among(wind.air, species.canopy_height, taller, along);
		const float *alone = species.canopy_height > 0.0f ? nullptr : &length;
		sample_air(wind, moments, &root.x, &root.z, alone, 1, &x, &z, SimdLevel::baseline);
	} else {
		float newtons = 0.0f;
		wind_kernels(SimdLevel::baseline).sample(wind, &root.x, &root.z, 1, &newtons);
		const float drag = newtons_of_air(species);
		const float speed = drag > 0.0f ? std::sqrt(std::max(newtons, 0.0f) / drag) : 0.0f;
		x = speed * along.x;
		z = speed * along.z;
	}
	add_sources(wind.sources, root, root, &root.x, &root.y, &root.z, &length, 1, &x, &z);
	const float speed = std::hypot(x, z);
	return std::isfinite(speed) ? speed : 0.0f;
}

void PartAir::step(float speed, double seconds) {
	mean += (static_cast<double>(speed) - mean) * (1.0 - std::exp(-seconds / MEMORY));
	gone += seconds * FASTER * mean / (mean + HALF_AS_FAST_AT);
	gone -= std::floor(gone);
}

} // namespace undergrowth

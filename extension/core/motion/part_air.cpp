#include "motion/part_air.hpp"

#include "motion/joint_constants.hpp"
#include "wind/air_sources.hpp"

#include <glm/geometric.hpp>

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

/// Speed (m/s) of draughts between plants in light air of `speed` m/s at 10 m: convection over warm ground adds gusts
/// of about half a metre per second to a weak wind (Beljaars 1995). None in still air, and none from Beaufort 3 on.
float draught_in(float speed) {
	constexpr float DRAUGHT = 0.6f;
	constexpr float LIGHT_AIR = 0.3f; // m/s: Beaufort 1 begins.
	constexpr float GENTLE_BREEZE = 3.4f; // m/s: Beaufort 3 begins.
	return DRAUGHT * std::min(speed / LIGHT_AIR, 1.0f) * std::max(1.0f - speed / GENTLE_BREEZE, 0.0f);
}

} // namespace

static void add_sources_at(const WindSnapshot &wind, float length, const glm::vec3 &root, glm::vec2 &velocity) {
	add_sources(wind.sources, root, root + glm::vec3(0.0f, length, 0.0f), &root.x, &root.y, &root.z, &length, 1,
			&velocity.x, nullptr, &velocity.y);
}

glm::vec2 air_at(const WindSnapshot &wind, const PlantWinds &along, float canopy_height, const TallerPlants &taller,
		float length, const glm::vec3 &root) {
	glm::vec2 velocity(0.0f);
	const AirMoments moments = moments_among(wind.air, canopy_height, taller, along);
	const float *alone = canopy_height > 0.0f ? nullptr : &length;
	sample_air(wind, moments, &root.x, &root.z, alone, 1, &velocity.x, &velocity.y, SimdLevel::baseline);
	add_sources_at(wind, length, root, velocity);
	return velocity;
}

float air_speed_at(const WindSnapshot &wind, const PlantWinds &along, const MotionSpecies &species,
		const TallerPlants &taller, float length, const glm::vec3 &root) {
	glm::vec2 velocity(0.0f);
	if (wind.is_air) {
		velocity = air_at(wind, along, species.canopy_height, taller, length, root);
	} else {
		float newtons = 0.0f;
		wind_kernels(SimdLevel::baseline).sample(wind, &root.x, &root.z, 1, &newtons);
		const float drag = newtons_of_air(species);
		const float speed = drag > 0.0f ? std::sqrt(std::max(newtons, 0.0f) / drag) : 0.0f;
		velocity = speed * glm::vec2(along.x, along.z);
		add_sources_at(wind, length, root, velocity);
	}
	const float speed = glm::length(velocity);
	const float least = wind.is_air ? draught_in(wind.air.speed) : 0.0f;
	return std::isfinite(speed) ? std::max(speed, least) : 0.0f;
}

void PartAir::step(float speed, double seconds) {
	mean += (static_cast<double>(speed) - mean) * (1.0 - std::exp(-seconds / MEMORY));
	gone += seconds * FASTER * mean / (mean + HALF_AS_FAST_AT);
	gone -= std::floor(gone);
}

} // namespace undergrowth

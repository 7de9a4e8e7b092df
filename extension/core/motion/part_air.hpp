#pragma once

#include "motion/motion_species.hpp"
#include "wind/air.hpp"

#include <glm/vec2.hpp>

namespace undergrowth {

/// Velocity (m/s, x and z of the axes of `wind`) of the air that moves a plant of `length` metres at `root`, with its
/// sources and gusts. The plant is in a canopy of `canopy_height`, or isolated at 0, among `taller` plants. The wind is
/// in m/s.
glm::vec2 air_at(const WindSnapshot &wind, const PlantWinds &along, float canopy_height, const TallerPlants &taller,
		float length, const glm::vec3 &root);

/// Speed (m/s) of the wind at the top of a plant of `length` metres at `root`, in the axes of `wind`, with its sources
/// and gusts. A wind in newtons counts as the air that bends the species as far. In light air (Beaufort 1 and 2) at
/// least that of draughts, so that light leaves move.
float air_speed_at(const WindSnapshot &wind, const PlantWinds &along, const MotionSpecies &species,
		const TallerPlants &taller, float length, const glm::vec3 &root);

/// The air that makes parts of plants flutter (StemMotion): the mean of the last second, and turns that go on faster in
/// faster air, so that flutter has no fixed frequency.
class PartAir {
public:
	static constexpr double MEMORY = 1.0; ///< s: time constant of the mean.
	static constexpr double FASTER = 0.6; ///< Additional turns per second in a gale.
	static constexpr double HALF_AS_FAST_AT = 3.0; ///< m/s: half of that.

	/// Adds a step of `seconds` in air of `speed` m/s.
	void step(float speed, double seconds);
	/// m/s.
	float speed() const { return static_cast<float>(mean); }
	/// 0 to 1.
	float turns() const { return static_cast<float>(gone); }

private:
	double mean = 0.0;
	double gone = 0.0;
};

} // namespace undergrowth

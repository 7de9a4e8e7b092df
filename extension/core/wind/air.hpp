#pragma once

#include "wind/air_tiles.hpp"
#include "wind/wind_kernels.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace undergrowth {

/// Wind in the terms of a weather report, and the offsets of its frozen patterns. Positions are horizontal, in metres
/// of the world.
///
/// The wind carries each pattern along, by its own distance. The velocity at a position is the pattern at that
/// position, rotated into the wind's axes about the world's origin, minus the distance. So the velocity depends on
/// nothing but the members and the time. A change of the speed continues all patterns, and so does a change of the
/// direction at the origin.
struct Air {
	float speed = 0.0f; ///< m/s at 10 m, >= 0.
	float turbulence = -1.0f; ///< Standard deviation over the mean speed, at 10 m; below 0: that of the roughness.
	float gustiness = 0.1f; ///< 0 to 0.15: asymmetry of gusts and lulls; a skewness of about 6 times this.
	float roughness = 0.03f; ///< m, of the open ground, > 0.
	float canopy_height = 0.5f; ///< m, height of the canopy that waves cross; 0: none.
	float canopy_wave_amount = 0.3f; ///< 0 to 1: fraction of the variance above a canopy.
	double heading = 0.0; ///< rad, as Wind::direction.

	double since = 0.0; ///< s: the time at which the distances were:
	double turbulence_way = 0.0; ///< m, of turbulence above open ground.
	double eddies_way = 0.0; ///< Of eddies there.
	double canopy_way = 0.0; ///< Of both above a canopy.
	double waves_way = 0.0;
};

/// Maps local axes, which may be rotated and scaled, to the world.
struct AirAxes {
	glm::dvec2 origin = { 0.0, 0.0 }; ///< m, in the world.
	glm::dvec2 x = { 1.0, 0.0 }; ///< World vector of one metre along x.
	glm::dvec2 z = { 0.0, 1.0 };
};

/// Speeds (m/s) at which the wind carries turbulence and eddies above open ground: the wind's at 1 m and at 10 m.
double turbulence_speed(const Air &air);
double eddies_speed(const Air &air);
/// Speed of all patterns over the canopy (m/s), 1.8 times the speed at its top (Finnigan 2000), and the length of waves
/// (m). Without a canopy the speed of turbulence.
double canopy_pattern_speed(const Air &air);
double waves_length(const Air &air);

/// Changes the wind to `wanted` at `time`. The patterns keep their distances.
void change_air(Air &air, const Air &wanted, double time);

/// The wind at one time, in the form that the kernels read. Null `tiles`: no turbulence. Values that are not finite
/// count as 0, values out of range as the nearest valid one.
AirSnapshot air_at_time(const Air &air, const AirAxes &axes, const AirTiles *tiles, double time);

/// Velocity (m/s, world) at a place whose height above open ground is `place.y`.
glm::vec3 air_velocity(const Air &air, const AirTiles *tiles, double time, const glm::vec3 &place);

/// Wind at `height` (m) within a canopy of `canopy_height` or above it, with directions in the axes of `axes`. A height
/// of 0 or less: the canopy's top. A canopy height of 0: isolated plants on open ground.
AirMoments moments_over(const AirSnapshot &air, float canopy_height, const PlantWinds &axes, float height = 0.0f);

/// Plants that are higher than a plant and shelter it.
struct TallerPlants {
	float height = 0.0f; ///< m, of their canopy; 0: none.
	float cover = 0.0f; ///< 0 to 1: a closed canopy.

	bool operator==(const TallerPlants &other) const { return height == other.height && cover == other.cover; }
};

/// Wind at the top of plants of `canopy_height` among taller ones: in a closed canopy that at their height within it,
/// by the extinction law, else a mean by `cover` of that and of the wind without taller plants.
AirMoments moments_among(
		const AirSnapshot &air, float canopy_height, const TallerPlants &taller, const PlantWinds &axes);

/// Writes the velocities (m/s) at plants (x, z), in the axes of `moments`, to out_x and out_z. `lengths` (m) are the
/// heights of isolated plants; null above a canopy.
void sample_air(const WindSnapshot &wind, const AirMoments &moments, const float *x, const float *z,
		const float *lengths, int count, float *out_x, float *out_z, SimdLevel level = best_simd_level());

/// Adds a triggered gust, in m/s, to velocities of air.
void add_gust(const WindSnapshot &wind, const AirMoments &moments, const float *x, const float *z, int count,
		float *out_x, float *out_z, SimdLevel level = best_simd_level());

} // namespace undergrowth

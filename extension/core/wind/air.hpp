#pragma once

#include "wind/air_tiles.hpp"
#include "wind/wind_kernels.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace undergrowth {

/// Wind in the terms of a weather report, and the offsets of its frozen patterns. Positions are horizontal, in metres
/// of the world.
///
/// The wind carries each pattern along. The velocity at a position is the pattern at that position, rotated into the
/// wind's axes, minus the pattern's offset.
struct Air {
	float speed = 0.0f; ///< m/s at 10 m, >= 0.
	float turbulence = -1.0f; ///< Standard deviation over the mean speed, at 10 m; below 0: that of the roughness.
	float gustiness = 0.1f; ///< 0 to 0.15: asymmetry of gusts and lulls; a skewness of about 6 times this.
	float roughness = 0.03f; ///< m, of the open ground, > 0.
	float canopy_height = 0.5f; ///< m, height of the canopy that waves cross; 0: none.
	float canopy_wave_amount = 0.3f; ///< 0 to 1: fraction of the variance above a canopy.
	double heading = 0.0; ///< rad, as Wind::direction.

	double since = 0.0; ///< s: the time at which the offsets were:
	glm::dvec2 turbulence_way = { 0.0, 0.0 }; ///< m, along the wind and across it.
	glm::dvec2 waves_way = { 0.0, 0.0 };
};

/// Maps local axes, which may be rotated and scaled, to the world.
struct AirAxes {
	glm::dvec2 origin = { 0.0, 0.0 }; ///< m, in the world.
	glm::dvec2 x = { 1.0, 0.0 }; ///< World vector of one metre along x.
	glm::dvec2 z = { 0.0, 1.0 };
};

/// Speed at which the wind carries turbulence (m/s): the wind speed 1 m above open ground.
double turbulence_speed(const Air &air);
/// Speed of waves over the canopy (m/s), 1.8 times the speed at its top (Finnigan 2000), and their length (m).
double waves_speed(const Air &air);
double waves_length(const Air &air);

/// Offsets of the patterns at `time`.
glm::dvec2 turbulence_way(const Air &air, double time);
glm::dvec2 waves_way(const Air &air, double time);

/// Changes the wind to `wanted` at `time`. The patterns remain continuous at `pivot`.
void change_air(Air &air, const Air &wanted, double time, const glm::dvec2 &pivot);

/// The wind at one time, in the form that the kernels read. Null `tiles`: no turbulence. Values that are not finite
/// count as 0, values out of range as the nearest valid one.
AirSnapshot air_at_time(const Air &air, const AirAxes &axes, const AirTiles *tiles, double time);

/// Velocity (m/s, world) at a place whose height above open ground is `place.y`.
glm::vec3 air_velocity(const Air &air, const AirTiles *tiles, double time, const glm::vec3 &place);

/// Wind at the top of a canopy of `canopy_height` (m), with directions in the axes of `axes`. 0: isolated plants on
/// open ground.
AirMoments moments_over(const AirSnapshot &air, float canopy_height, const PlantWinds &axes);

/// Writes the velocities (m/s) at plants (x, z), in the axes of `moments`, to out_x and out_z. `lengths` (m) are the
/// heights of isolated plants; null above a canopy.
void sample_air(const WindSnapshot &wind, const AirMoments &moments, const float *x, const float *z,
		const float *lengths, int count, float *out_x, float *out_z, SimdLevel level = best_simd_level());

/// Adds a triggered gust, in m/s, to velocities of air.
void add_gust(const WindSnapshot &wind, const AirMoments &moments, const float *x, const float *z, int count,
		float *out_x, float *out_z, SimdLevel level = best_simd_level());

} // namespace undergrowth

#pragma once

#include "wind/air_tiles.hpp"
#include "wind/wind_kernels.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace undergrowth {

/// Wind as a weather report says it, and where its frozen patterns are. Places are horizontal, in metres of the world.
///
/// A pattern is carried along by the wind: what a place feels at a time is the pattern at the place, turned into the
/// wind's axes, less the way that it has gone.
struct Air {
	float speed = 0.0f; ///< m/s at 10 m, >= 0.
	float turbulence = -1.0f; ///< Standard deviation over the mean speed, at 10 m; below 0: that of the roughness.
	float gustiness = 0.1f; ///< 0 to 0.15: how much faster rare gusts are than lulls are slow; a skewness of about 6.
	float roughness = 0.03f; ///< m, of the open ground, > 0.
	float stand_height = 0.5f; ///< m, of the stand that waves run over; 0: none.
	float wave_share = 0.3f; ///< 0 to 1: of the variance over a stand.
	double heading = 0.0; ///< rad, as Wind::direction.

	double since = 0.0; ///< s: when patterns had gone so far:
	glm::dvec2 turbulence_way = { 0.0, 0.0 }; ///< m, along the wind and across it.
	glm::dvec2 waves_way = { 0.0, 0.0 };
};

/// From axes that places are given in to the world's: those of a field may be turned and scaled.
struct AirAxes {
	glm::dvec2 origin = { 0.0, 0.0 }; ///< m, in the world.
	glm::dvec2 x = { 1.0, 0.0 }; ///< Of a metre along x.
	glm::dvec2 z = { 0.0, 1.0 };
};

/// How fast turbulence is carried along (m/s): as the wind blows a metre above open ground.
double turbulence_speed(const Air &air);
/// How fast waves run over the stand (m/s), 1.8 times the speed at its top (Finnigan 2000), and their length (m).
double waves_speed(const Air &air);
double waves_length(const Air &air);

/// How far patterns have gone at `time`.
glm::dvec2 turbulence_way(const Air &air, double time);
glm::dvec2 waves_way(const Air &air, double time);

/// From `time` on it blows as `wanted` says; at `pivot` patterns go on as they were.
void change_air(Air &air, const Air &wanted, double time, const glm::dvec2 &pivot);

/// It at one time, ready for the kernels; where it is still, nothing is sampled. Null tiles: no turbulence. Numbers
/// that are none or out of range count as 0 or as the nearest.
AirNow air_at_time(const Air &air, const AirAxes &axes, const AirTiles *tiles, double time);

/// Velocity (m/s, world) at a place whose height above open ground is `place.y`.
glm::vec3 air_velocity(const Air &air, const AirTiles *tiles, double time, const glm::vec3 &place);

/// How it blows over the tops of a stand so high (m), with directions in the axes of `axes`. 0: where each plant stands
/// alone, on open ground.
AirBlow blow_over(const AirNow &air, float stand_height, const PlantWinds &axes);

/// The velocities (m/s) of air at plants (x, z), in the axes of `blow`, to out_x and out_z; where they stand alone,
/// `lengths` are theirs (m), else null.
void sample_air(const TravellingWind &wind, const AirBlow &blow, const float *x, const float *z, const float *lengths,
		int count, float *out_x, float *out_z, SimdLevel level = best_simd_level());

/// Adds a gust that somebody called for, in m/s, to velocities of air.
void add_gust(const TravellingWind &wind, const AirBlow &blow, const float *x, const float *z, int count, float *out_x,
		float *out_z, SimdLevel level = best_simd_level());

} // namespace undergrowth

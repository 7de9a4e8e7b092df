#pragma once

#include "base/simd.hpp"

#include <cstdint>

namespace undergrowth {

/// A wind along one horizontal unit direction, of a strength (N, >= 0) of its own for each plant.
struct PlantWinds {
	const float *strengths;
	float x, z;
	float side_x = 0.0f; ///< Unit, across the wind: where the other component of air blows to.
	float side_z = 0.0f;
};

/// A periodic map (AirTiles) at one time: the texel of a place (x, z) is (s + s_x·x + s_z·z, n + n_x·x + n_z·z), in
/// parts of a texel.
struct AirMap {
	const uint64_t *cells = nullptr; ///< Null: none.
	float s = 0.0f, s_x = 0.0f, s_z = 0.0f;
	float n = 0.0f, n_x = 0.0f, n_z = 0.0f;
	/// Places see those so far from the map's corner where they are farther: 65 km. Always; a variable as
	/// TravellingWind::half.
	float farthest = 1073741824.0f;
	static constexpr float PARTS = 4096.0f; ///< Of a texel.
};

/// Air at one time, for all who feel it.
struct AirNow {
	float speed = 0.0f; ///< m/s at 10 m; 0: still.
	float gusts = 1.0f; ///< Standard deviations, as a multiple of those of the roughness.
	float roughness = 0.0f; ///< m.
	float skew = 0.0f; ///< Gustiness.
	float wave_share = 0.0f; ///< Of the variance over a stand.
	AirMap turbulence; ///< In metres of the places' axes.
	AirMap waves;
};

/// Velocity along the wind, mean + gust·(u + skew·(u² - 1)), and across it, side_gust·v.
struct AirBlow {
	float mean, gust, side_gust; ///< m/s.
	float skew;
	float along_x, along_z, side_x, side_z; ///< Unit directions.
};

/// How air grows with the height above open ground, for plants that stand alone: what AirBlow says holds above the
/// rough layer, but that its mean is for a logarithm of 1.
struct AirGround {
	float over_roughness, over_layer; ///< 1/m.
	float layer; ///< Over the roughness.
};

/// Four samples of each plant of what blows there along x and z, in the order of their times: 16 bits each, in 1/256 of
/// a metre a second, two in a word, the earlier one in the low bits. Side by side, AIR_GROUP words each: the first two
/// of x of as many plants, the last two of x, and the same of z.
inline constexpr int AIR_GROUP = 8;
inline constexpr int AIR_GROUP_WORDS = 4 * AIR_GROUP;

/// What each of four samples counts, in 1/4096, in words likewise; and what is added (m/s).
struct AirWeights {
	uint32_t early, late;
	float x, z;
};

struct AirSource;
struct AirDrift;

/// What stirs the air at single places (air_sources.hpp), for plants whose directions have axes of their own: there, a
/// metre along x of the roots' axes is (x_x, x_z), one along z is (z_x, z_z).
struct AirSources {
	const AirSource *all = nullptr;
	int count = 0;
	float x_x = 1.0f, x_z = 0.0f;
	float z_x = 0.0f, z_z = 1.0f;
};

/// A wind that travels over the ground, at one time. The place in its period (cycles) of a plant at (x, z) is
/// cycle - cycles_x·x - cycles_z·z, and a gust started since - max(delay_x·x + delay_z·z, least_delay) seconds ago.
struct TravellingWind {
	float steady; ///< N, always.
	float wave; ///< N: wave·(1 + sin(2π·cycles)).
	float burst; ///< N, in the first half of each cycle.
	float gust; ///< N, from 0 to `duration` after the gust's start.
	float cycle, cycles_x, cycles_z; ///< Cycles; cycles/m.
	float since, delay_x, delay_z; ///< s; s/m.
	float duration; ///< s.
	float least_delay = 0.0f; ///< s.
	float half = 0.5f; ///< Of a cycle. Always; a variable because compilers bound by it in fewer instructions.
	bool is_air = false; ///< Then `air` blows, and of the others the gust only, in m/s.
	AirNow air = {};
	AirSources sources = {}; ///< Felt whatever else blows.
	const AirDrift *drift = nullptr; ///< Null: no root moves. Felt whatever else blows.
};

/// One build of the kernels of wind. All builds give the same bits.
struct WindKernels {
	/// The strength (N) of `wind` at the plants (x, z) (m) to out[0 .. count).
	void (*sample)(const TravellingWind &wind, const float *x, const float *z, int count, float *out);
	/// Both components of turbulence at the plants, in standard deviations.
	void (*sample_turbulence)(
			const AirMap &map, const float *x, const float *z, int count, float *along, float *across);
	/// along[i] becomes keep·along[i] + share·(the waves over a stand, in standard deviations).
	void (*add_stand_waves)(
			const AirMap &map, const float *x, const float *z, int count, float keep, float share, float *along);
	/// Makes velocities of both components, in place: those along x and along z.
	void (*make_velocities)(const AirBlow &blow, int count, float *along, float *across);
	/// The oldest of four samples goes, velocities (m/s) along x and z come.
	void (*keep_samples)(const float *x, const float *z, int count, uint32_t *groups);
	/// What the four make (m/s).
	void (*between_samples)(const uint32_t *groups, const AirWeights &weights, int count, float *x, float *z);
	/// make_velocities() for plants of such lengths (m) that stand alone.
	void (*make_lone_velocities)(
			const AirBlow &blow, const AirGround &ground, const float *lengths, int count, float *along, float *across);
};

const WindKernels *baseline_wind_kernels();
/// Null where this build has none.
const WindKernels *avx2_wind_kernels();

/// The kernels of `level`, or the baseline where this processor or build has no such level.
const WindKernels &wind_kernels(SimdLevel level);

} // namespace undergrowth

#pragma once

#include "base/simd.hpp"
#include "wind/precipitation.hpp"

#include <cstdint>

namespace undergrowth {

/// Winds along one horizontal unit direction, with one strength (N, >= 0) per plant.
struct PlantWinds {
	const float *strengths;
	float x, z;
	float side_x = 0.0f; ///< Unit vector across the wind: direction of the second component of air.
	float side_z = 0.0f;
};

/// A periodic map (AirTiles) at one time. The texel of a position (x, z) is (s + s_x·x + s_z·z, n + n_x·x + n_z·z), in
/// 1/PARTS of a texel. To n it adds sway·sin(2π·(turn + turn_x·x + turn_z·z)).
struct AirMap {
	const uint64_t *cells = nullptr; ///< Null: none.
	float s = 0.0f, s_x = 0.0f, s_z = 0.0f;
	float n = 0.0f, n_x = 0.0f, n_z = 0.0f;
	float sway = 0.0f;
	float turn = 0.0f, turn_x = 0.0f, turn_z = 0.0f;
	/// Maximum distance from the map's corner (65 km); farther positions are clamped. A variable for the reason given
	/// at WindSnapshot::half.
	float farthest = 1073741824.0f;
	float half = 0.5f; ///< Of a turn. A variable for the same reason.
	static constexpr float PARTS = 4096.0f; ///< Per texel.
};

/// Maps of turbulence, which the wind carries at different speeds.
struct AirPatterns {
	AirMap turbulence, eddies;
};

/// Air at one time, for all plants.
struct AirSnapshot {
	float speed = 0.0f; ///< m/s at 10 m; 0: still.
	float gusts = 1.0f; ///< Standard deviations, relative to those of the roughness.
	float roughness = 0.0f; ///< m.
	float skew = 0.0f; ///< Gustiness.
	float canopy_wave_amount = 0.0f; ///< Fraction of the variance above a canopy.
	AirPatterns open; ///< Above open ground. In metres of the places' axes.
	AirPatterns canopy;
	AirMap waves;
	float waves_bent =
			0.0f; ///< Displacement of waves along the wind per standard deviation of the eddies, in 1/PARTS of a texel.
};

/// Velocity along the wind, mean + gust·(u + skew·(u² - 1)), and across it, side_gust·v.
struct AirMoments {
	float mean, gust, side_gust; ///< m/s.
	float skew;
	float along_x, along_z, side_x, side_z; ///< Unit directions.
	float small = 1.0f, eddies = 0.0f, waves = 0.0f; ///< Standard deviations within u.
	float side_small = 1.0f, side_eddies = 0.0f; ///< Within v.
};

/// Deviates at plants: both components of the eddies, and the waves.
struct AirDeviates {
	const float *along, *across, *waves;
};

/// Growth of the wind with the height above open ground, for isolated plants. AirMoments then holds above the rough
/// layer, and its mean is that of a logarithm of 1.
struct AirGround {
	float over_roughness, over_layer; ///< 1/m.
	float layer; ///< Relative to the roughness.
	float eddies, eddies_growth; ///< Standard deviation of the eddies: eddies + eddies_growth·(that logarithm).
	float max_eddies = 1.0f; ///< A variable for the reason given at WindSnapshot::half.
};

/// Four samples of the velocity along x and z per plant, in the order of their times: 16 bits each, in 1/256 m/s, two
/// per word, the earlier one in the low bits. A group has AIR_GROUP words of each: the first two samples of x, the last
/// two of x, and the same of z.
inline constexpr int AIR_GROUP = 8;
inline constexpr int AIR_GROUP_WORDS = 4 * AIR_GROUP;

/// Weights of the four samples, in 1/4096, in the same layout; and an offset (m/s).
struct AirWeights {
	uint32_t early, late;
	float x, z;
};

struct AirSource;
struct AirDrift;

/// Local sources of wind (air_sources.hpp). One metre along x of the roots' axes is (x_x, x_z) in the axes of the
/// velocities, one along z is (z_x, z_z).
struct AirSources {
	const AirSource *all = nullptr;
	int count = 0;
	float x_x = 1.0f, x_z = 0.0f;
	float z_x = 0.0f, z_z = 1.0f;
};

/// A travelling wind at one time. The phase (cycles) at a plant (x, z) is cycle - cycles_x·x - cycles_z·z. A gust
/// started since - max(delay_x·x + delay_z·z, min_delay) seconds ago.
struct WindSnapshot {
	float steady; ///< N, always.
	float wave; ///< N: wave·(1 + sin(2π·cycles)).
	float burst; ///< N, in the first half of each cycle.
	float gust; ///< N, from 0 to `duration` after the gust's start.
	float cycle, cycles_x, cycles_z; ///< Cycles; cycles/m.
	float since, delay_x, delay_z; ///< s; s/m.
	float duration; ///< s.
	float min_delay = 0.0f; ///< s.
	float half = 0.5f; ///< Of a cycle. Constant; a variable because compilers then clamp in fewer instructions.
	bool is_air = false; ///< True: uses `air` and the gust, in m/s, and nothing else.
	AirSnapshot air = {};
	AirSources sources = {}; ///< Added to every kind of wind.
	Precipitation precipitation = {};
	const AirDrift *drift = nullptr; ///< Velocities of moving roots, subtracted from every kind of wind; null: none.
};

/// One build of the kernels of wind. All builds give the same bits.
struct WindKernels {
	/// Writes the strength (N) of `wind` at the plants (x, z) (m) to out[0 .. count).
	void (*sample)(const WindSnapshot &wind, const float *x, const float *z, int count, float *out);
	/// Both components of turbulence or eddies at the plants, in standard deviations.
	void (*sample_turbulence)(
			const AirMap &map, const float *x, const float *z, int count, float *along, float *across);
	/// Waves over a canopy at the plants, in standard deviations. The map is displaced by bent·eddies[i] along the
	/// wind.
	void (*sample_waves)(const AirMap &map, float bent, const float *eddies, const float *x, const float *z, int count,
			float *waves);
	/// Converts both components of turbulence to velocities along x and z, in place.
	void (*make_velocities)(
			const AirMoments &moments, const AirDeviates &others, int count, float *along, float *across);
	/// Replaces the oldest of four samples by velocities (m/s) along x and z.
	void (*keep_samples)(const float *x, const float *z, int count, uint32_t *groups);
	/// Interpolates the four samples (m/s).
	void (*between_samples)(const uint32_t *groups, const AirWeights &weights, int count, float *x, float *z);
	/// make_velocities() for isolated plants of given `lengths` (m).
	void (*make_isolated_velocities)(const AirMoments &moments, const AirGround &ground, const AirDeviates &others,
			const float *lengths, int count, float *along, float *across);
};

const WindKernels *baseline_wind_kernels();
/// Null if this build has none.
const WindKernels *avx2_wind_kernels();

/// The kernels of `level`, or the baseline if this processor or build lacks that level.
const WindKernels &wind_kernels(SimdLevel level);

} // namespace undergrowth

#pragma once

#include "base/simd.hpp"

#include <cstdint>

namespace undergrowth {

/// A wind along one horizontal unit direction, of a strength (N, >= 0) of its own for each plant.
struct PlantWinds {
	const float *strengths;
	float x, z;
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
};

/// One build of the kernels of wind. All builds give the same bits.
struct WindKernels {
	/// The strength (N) of `wind` at the plants (x, z) (m) to out[0 .. count).
	void (*sample)(const TravellingWind &wind, const float *x, const float *z, int count, float *out);
};

const WindKernels *baseline_wind_kernels();
/// Null where this build has none.
const WindKernels *avx2_wind_kernels();

/// The kernels of `level`, or the baseline where this processor or build has no such level.
const WindKernels &wind_kernels(SimdLevel level);

} // namespace undergrowth

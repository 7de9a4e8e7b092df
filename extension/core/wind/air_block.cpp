// Effect of air on blocks of plants.

#include "wind/air.hpp"
#include "wind/air_profile.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

/// Number of plants in one sampling of gusts.
constexpr int GUST_BLOCK = 64;

/// Scale of gusts and lulls that gives a variance of 1.
float unit_gust(float skew) {
	return 1.0f / std::sqrt(1.0f + 2.0f * skew * skew);
}

/// Velocities of isolated plants: each has the wind of its own height above open ground.
void sample_isolated(const AirSnapshot &air, const float *lengths, AirMoments moments, int count, float *x, float *z,
		const WindKernels &kernels) {
	const OpenGround open(static_cast<double>(air.roughness));
	const float gust = air.speed * air.gusts * static_cast<float>(open.gusts(REFERENCE_HEIGHT));
	moments.mean = air.speed * static_cast<float>(open.growth());
	moments.gust = gust * unit_gust(air.skew);
	moments.side_gust = gust * static_cast<float>(SIDE_GUSTS);
	const double layer = OpenGround::ROUGH_LAYER;
	const AirGround ground = { static_cast<float>(1.0 / open.roughness()),
		static_cast<float>(1.0 / (layer * open.roughness())), static_cast<float>(layer) };
	kernels.make_isolated_velocities(moments, ground, lengths, count, x, z);
}

} // namespace

AirMoments moments_over(const AirSnapshot &air, float canopy_height, const PlantWinds &axes) {
	AirMoments moments = { 0.0f, 0.0f, 0.0f, air.skew, axes.x, axes.z, axes.side_x, axes.side_z };
	if (canopy_height > 0.0f) {
		moments.mean = air.speed * static_cast<float>(canopy_top_speed(static_cast<double>(canopy_height)));
		const float gust = moments.mean * static_cast<float>(CANOPY_GUSTS) * air.gusts;
		moments.gust = gust * unit_gust(air.skew);
		moments.side_gust = gust * static_cast<float>(SIDE_GUSTS);
	}
	return moments;
}

void add_gust(const WindSnapshot &wind, const AirMoments &moments, const float *x, const float *z, int count,
		float *out_x, float *out_z, SimdLevel level) {
	if (wind.gust == 0.0f) {
		return;
	}
	float strengths[GUST_BLOCK];
	for (int begin = 0; begin < count; begin += GUST_BLOCK) {
		const int some = std::min(GUST_BLOCK, count - begin);
		wind_kernels(level).sample(wind, x + begin, z + begin, some, strengths);
		for (int i = 0; i < some; i++) {
			out_x[begin + i] += strengths[i] * moments.along_x;
			out_z[begin + i] += strengths[i] * moments.along_z;
		}
	}
}

void sample_air(const WindSnapshot &wind, const AirMoments &moments, const float *x, const float *z,
		const float *lengths, int count, float *out_x, float *out_z, SimdLevel level) {
	const WindKernels &kernels = wind_kernels(level);
	const AirSnapshot &air = wind.air;
	if (air.turbulence.cells) {
		kernels.sample_turbulence(air.turbulence, x, z, count, out_x, out_z);
	} else {
		std::fill(out_x, out_x + count, 0.0f);
		std::fill(out_z, out_z + count, 0.0f);
	}
	if (air.waves.cells && !lengths) {
		const float kept = std::sqrt(1.0f - air.canopy_wave_amount);
		kernels.add_canopy_waves(air.waves, x, z, count, kept, std::sqrt(air.canopy_wave_amount), out_x);
	}
	if (lengths) {
		sample_isolated(air, lengths, moments, count, out_x, out_z, kernels);
	} else {
		kernels.make_velocities(moments, count, out_x, out_z);
	}
	add_gust(wind, moments, x, z, count, out_x, out_z, level);
}

} // namespace undergrowth

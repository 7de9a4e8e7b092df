// Effect of air on blocks of plants.

#include "base/portable_math.hpp"
#include "wind/air.hpp"
#include "wind/air_profile.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

/// Number of plants that are sampled together.
constexpr int BLOCK = 512;
/// Number of plants in one sampling of gusts.
constexpr int GUST_BLOCK = 64;

/// Scale of gusts and lulls that gives a variance of 1.
float unit_gust(float skew) {
	return 1.0f / std::sqrt(1.0f + 2.0f * skew * skew);
}

/// Velocities of isolated plants: each has the wind of its own height above open ground.
void make_isolated(const AirSnapshot &air, const float *lengths, AirMoments moments, const AirDeviates &others,
		int count, float *x, float *z, const WindKernels &kernels) {
	const OpenGround open(static_cast<double>(air.roughness));
	const float gust = air.speed * air.gusts * static_cast<float>(open.gusts(REFERENCE_HEIGHT));
	moments.mean = air.speed * static_cast<float>(open.growth());
	moments.gust = gust * unit_gust(air.skew);
	moments.side_gust = gust * static_cast<float>(SIDE_GUSTS);
	const double layer = OpenGround::ROUGH_LAYER;
	const AirGround ground = { static_cast<float>(1.0 / open.roughness()),
		static_cast<float>(1.0 / (layer * open.roughness())), static_cast<float>(layer),
		static_cast<float>(EDDIES_AT_ONE + EDDIES_GROWTH * portable_log(open.roughness())),
		static_cast<float>(EDDIES_GROWTH) };
	kernels.make_isolated_velocities(moments, ground, others, lengths, count, x, z);
}

/// Deviates of both scales at `count` plants, BLOCK at most.
struct Deviates {
	float eddies_along[BLOCK], eddies_across[BLOCK], waves[BLOCK];

	Deviates(const AirSnapshot &air, bool is_canopy, const float *x, const float *z, int count, float *along,
			float *across, const WindKernels &kernels) {
		const AirPatterns &patterns = is_canopy ? air.canopy : air.open;
		if (patterns.turbulence.cells) {
			kernels.sample_turbulence(patterns.eddies, x, z, count, eddies_along, eddies_across);
			kernels.sample_turbulence(patterns.turbulence, x, z, count, along, across);
		} else {
			for (float *none : { eddies_along, eddies_across, along, across }) {
				std::fill(none, none + count, 0.0f);
			}
		}
		if (is_canopy && air.waves.cells) {
			kernels.sample_waves(air.waves, air.waves_bent, eddies_along, x, z, count, waves);
		} else {
			std::fill(waves, waves + count, 0.0f);
		}
	}

	AirDeviates all() const { return { eddies_along, eddies_across, waves }; }
};

} // namespace

AirMoments moments_over(const AirSnapshot &air, float canopy_height, const PlantWinds &axes, float height) {
	AirMoments moments = { 0.0f, 0.0f, 0.0f, air.skew, axes.x, axes.z, axes.side_x, axes.side_z };
	if (canopy_height > 0.0f) {
		const auto canopy = static_cast<double>(canopy_height);
		const double above = height > 0.0f ? static_cast<double>(height) : canopy;
		const float gust = air.speed * static_cast<float>(canopy_gusts(above, canopy)) * air.gusts;
		moments.mean = air.speed * static_cast<float>(canopy_speed(above, canopy));
		moments.gust = gust * unit_gust(air.skew);
		moments.side_gust = gust * static_cast<float>(SIDE_GUSTS);
		const float kept = std::sqrt(1.0f - air.canopy_wave_amount);
		moments.side_eddies = static_cast<float>(CANOPY_EDDIES);
		moments.side_small = std::sqrt(1.0f - moments.side_eddies * moments.side_eddies);
		moments.eddies = kept * moments.side_eddies;
		moments.small = kept * moments.side_small;
		moments.waves = std::sqrt(air.canopy_wave_amount);
	}
	return moments;
}

AirMoments moments_among(
		const AirSnapshot &air, float canopy_height, const TallerPlants &taller, const PlantWinds &axes) {
	AirMoments moments = moments_over(air, canopy_height, axes);
	if (taller.cover > 0.0f && canopy_height > 0.0f && taller.height > canopy_height) {
		const AirMoments within = moments_over(air, taller.height, axes, canopy_height);
		moments.mean += taller.cover * (within.mean - moments.mean);
		moments.gust += taller.cover * (within.gust - moments.gust);
		moments.side_gust += taller.cover * (within.side_gust - moments.side_gust);
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
	for (int begin = 0; begin < count; begin += BLOCK) {
		const int some = std::min(BLOCK, count - begin);
		float *along = out_x + begin;
		float *across = out_z + begin;
		const Deviates deviates(wind.air, !lengths, x + begin, z + begin, some, along, across, kernels);
		if (lengths) {
			make_isolated(wind.air, lengths + begin, moments, deviates.all(), some, along, across, kernels);
		} else {
			kernels.make_velocities(moments, deviates.all(), some, along, across);
		}
	}
	add_gust(wind, moments, x, z, count, out_x, out_z, level);
}

} // namespace undergrowth

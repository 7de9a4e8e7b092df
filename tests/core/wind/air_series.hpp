#pragma once

#include "wind/air.hpp"
#include "wind/air_profile.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

/// One map for all tests, since its creation takes 0.1 s.
inline const undergrowth::AirTiles &shared_tiles() {
	static const std::shared_ptr<const undergrowth::AirTiles> tiles = undergrowth::make_air_tiles(0);
	return *tiles;
}

/// Air that carries turbulence with `speed` (m/s), without gustiness or waves, towards +z.
inline undergrowth::Air plain_air(float speed) {
	undergrowth::Air air;
	air.gustiness = 0.0f;
	air.canopy_wave_amount = 0.0f;
	air.speed = speed / static_cast<float>(undergrowth::open_ground_speed(1.0, static_cast<double>(air.roughness)));
	return air;
}

struct Series {
	std::vector<float> along, across; ///< Standard deviations.
};

/// Turbulence at a position (x, z) at `count` times, `step` seconds apart.
inline Series turbulence_at(const undergrowth::Air &air, float x, float z, int count, double step) {
	Series series = { std::vector<float>(static_cast<std::size_t>(count)),
		std::vector<float>(static_cast<std::size_t>(count)) };
	for (int i = 0; i < count; i++) {
		const undergrowth::AirSnapshot now = undergrowth::air_at_time(air, {}, &shared_tiles(), i * step);
		const auto k = static_cast<std::size_t>(i);
		undergrowth::baseline_wind_kernels()->sample_turbulence(
				now.turbulence, &x, &z, 1, &series.along[k], &series.across[k]);
	}
	return series;
}

inline double mean_of(const std::vector<float> &values) {
	double sum = 0.0;
	for (const float value : values) {
		sum += static_cast<double>(value);
	}
	return sum / static_cast<double>(values.size());
}

/// Mean product of two series, with one `lag` samples behind.
inline double product(const std::vector<float> &a, const std::vector<float> &b, std::size_t lag) {
	double sum = 0.0;
	for (std::size_t i = 0; i + lag < a.size(); i++) {
		sum += static_cast<double>(a[i]) * static_cast<double>(b[i + lag]);
	}
	return sum / static_cast<double>(a.size() - lag);
}

#pragma once

#include "base/random.hpp"
#include "wind/air.hpp"
#include "wind/air_profile.hpp"
#include "wind/field_wind.hpp"

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
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

/// Standard deviations of the wind at many positions, `height` above open ground.
class WindAt {
public:
	WindAt(const undergrowth::Air &air, float height, std::vector<float> along_x, std::vector<float> along_z) :
			x(std::move(along_x)), z(std::move(along_z)), heights(x.size(), height) {
		wind.wind.kind = undergrowth::WindKind::air;
		wind.air = air;
		wind.tiles =
				std::shared_ptr<const undergrowth::AirTiles>(&shared_tiles(), [](const undergrowth::AirTiles *) {});
		const auto above = static_cast<double>(height);
		const auto rough = static_cast<double>(air.roughness);
		mean = air.speed * static_cast<float>(undergrowth::open_ground_speed(above, rough));
		gust = air.speed * static_cast<float>(undergrowth::open_ground_gusts(above, rough));
	}

	/// At `time`, along the wind and across it; it blows towards +z.
	Series at(double time) const {
		Series now = { std::vector<float>(x.size()), std::vector<float>(x.size()) };
		const undergrowth::WindSnapshot snapshot = undergrowth::wind_at_time(wind, time);
		const undergrowth::AirMoments moments =
				undergrowth::moments_over(snapshot.air, 0.0f, undergrowth::winds_along(wind));
		undergrowth::sample_air(snapshot, moments, x.data(), z.data(), heights.data(), static_cast<int>(x.size()),
				now.across.data(), now.along.data());
		for (std::size_t i = 0; i < x.size(); i++) {
			now.along[i] = (now.along[i] - mean) / gust;
			now.across[i] /= gust * static_cast<float>(undergrowth::SIDE_GUSTS);
		}
		return now;
	}

	/// At each position, at `count` times, `step` seconds apart.
	std::vector<Series> series(int count, double step) const {
		std::vector<Series> all(x.size());
		for (int k = 0; k < count; k++) {
			const Series now = at(k * step);
			for (std::size_t i = 0; i < x.size(); i++) {
				all[i].along.push_back(now.along[i]);
				all[i].across.push_back(now.across[i]);
			}
		}
		return all;
	}

private:
	undergrowth::FieldWind wind;
	std::vector<float> x, z, heights;
	float mean = 0.0f, gust = 1.0f; ///< m/s.
};

/// Numbers from -size to size, evenly distributed.
inline std::vector<float> scattered(uint64_t which, int count, float size) {
	std::vector<float> all;
	for (int i = 0; i < count; i++) {
		all.push_back(size * undergrowth::signed_noise(which, static_cast<uint64_t>(i)));
	}
	return all;
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

// What air costs: its maps, once, and both components at each plant of a field's block, at each level.

#include "base/random.hpp"
#include "report.hpp"
#include "wind/field_wind.hpp"

using namespace undergrowth;

namespace {

constexpr int PLANTS = 100000;
constexpr int AT_ONCE = 512; // Plants of one tile of a field, whose winds are sampled together.
constexpr float TILE = 8.0f; // m.
constexpr float HEIGHT = 0.6f; // m.

/// Roots, block after block.
struct Roots {
	std::vector<float> x, z;

	Roots() {
		for (int i = 0; i < PLANTS; i++) {
			const auto block = static_cast<float>(i / AT_ONCE);
			x.push_back(block + TILE * signed_noise(1, static_cast<uint64_t>(i)));
			z.push_back(0.5f * block + TILE * signed_noise(2, static_cast<uint64_t>(i)));
		}
	}
};

void time_samples(Report &report, const char *name, const FieldWind &wind, SimdLevel level) {
	const Roots roots;
	float x[AT_ONCE], z[AT_ONCE];
	double time = 0.0;
	const double run = median_ms([&] {
		const WindSnapshot now = wind_at_time(wind, time);
		const AirMoments moments = moments_over(now.air, HEIGHT, winds_along(wind));
		time += 1.0 / 60.0;
		for (int begin = 0; begin < PLANTS; begin += AT_ONCE) {
			const auto first = static_cast<std::size_t>(begin);
			const int some = std::min(AT_ONCE, PLANTS - begin);
			sample_air(now, moments, &roots.x[first], &roots.z[first], nullptr, some, x, z, level);
		}
	});
	report.row(name, PLANTS, 1, run, level);
}

} // namespace

void undergrowth::time_air(Report &report) {
	constexpr int MAPS = 5;
	report.row("air_maps", 1, 1, median_ms([] { make_air_tiles(1); }, MAPS), SimdLevel::baseline);
	FieldWind wind;
	wind.wind.kind = WindKind::air;
	wind.air.speed = 9.0f;
	wind.tiles = make_air_tiles(0);
	for (const SimdLevel level : { SimdLevel::baseline, SimdLevel::avx2 }) {
		if (level <= best_simd_level()) {
			wind.air.canopy_wave_amount = 0.0f;
			time_samples(report, "air_sample", wind, level);
			wind.air.canopy_wave_amount = 0.3f;
			time_samples(report, "air_sample_waves", wind, level);
		}
	}
}

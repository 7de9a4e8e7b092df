#include "base/simd.hpp"
#include "wind/wind_kernels.hpp"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace undergrowth;

TEST_CASE("a burst lasts from the start of a period to just before its middle") {
	const float place = 0.0f;
	for (const SimdLevel level : { SimdLevel::baseline, best_simd_level() }) {
		for (const float cycle : { 0.0f, 0.25f, 0.4999f, 0.5f, 0.75f, 0.9999f, 1.0f, 1.5f }) {
			WindSnapshot wind = {};
			wind.burst = 3.0f;
			wind.cycle = cycle;
			float strength = -1.0f;
			wind_kernels(level).sample(wind, &place, &place, 1, &strength);
			CAPTURE(cycle);
			CHECK(strength == (cycle < 0.5f || cycle == 1.0f ? 3.0f : 0.0f));
		}
	}
}

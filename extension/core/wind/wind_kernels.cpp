#include "wind/wind_kernels.hpp"

namespace undergrowth {

const WindKernels &wind_kernels(SimdLevel level) {
	const bool wanted = level == SimdLevel::avx2 && best_simd_level() == SimdLevel::avx2;
	const WindKernels *best = wanted ? avx2_wind_kernels() : nullptr;
	return best ? *best : *baseline_wind_kernels();
}

} // namespace undergrowth

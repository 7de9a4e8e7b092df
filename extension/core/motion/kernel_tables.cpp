#include "motion/kernel_tables.hpp"

namespace undergrowth {

const KernelSet &kernels(SimdLevel level) {
	const bool wanted = level == SimdLevel::avx2 && best_simd_level() == SimdLevel::avx2;
	const KernelSet *best = wanted ? avx2_kernel_set() : nullptr;
	return best ? *best : *baseline_kernel_set();
}

} // namespace undergrowth

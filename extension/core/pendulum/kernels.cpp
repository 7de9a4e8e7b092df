#include "pendulum/kernels.hpp"

#include "pendulum/kernel_tables.hpp"

#if defined(_MSC_VER) && (defined(_M_X64) || defined(_M_IX86))
#include <immintrin.h>
#include <intrin.h>
#endif

namespace undergrowth {

namespace {

/// Whether the processor has AVX2 and the operating system saves its registers.
bool processor_has_avx2() {
#if defined(__GNUC__) && (defined(__x86_64__) || defined(__i386__))
	return __builtin_cpu_supports("avx2") != 0;
#elif defined(_MSC_VER) && (defined(_M_X64) || defined(_M_IX86))
	constexpr int OSXSAVE_AND_AVX = (1 << 27) | (1 << 28);
	constexpr int AVX2 = 1 << 5;
	constexpr unsigned long long XMM_AND_YMM = 6;
	int leaf[4];
	__cpuid(leaf, 0);
	if (leaf[0] < 7) {
		return false;
	}
	__cpuid(leaf, 1);
	if ((leaf[2] & OSXSAVE_AND_AVX) != OSXSAVE_AND_AVX || (_xgetbv(0) & XMM_AND_YMM) != XMM_AND_YMM) {
		return false;
	}
	__cpuidex(leaf, 7, 0);
	return (leaf[1] & AVX2) != 0;
#else
	return false;
#endif
}

} // namespace

SimdLevel best_simd_level() {
	static const SimdLevel best =
			avx2_kernel_set() != nullptr && processor_has_avx2() ? SimdLevel::avx2 : SimdLevel::baseline;
	return best;
}

const KernelSet &kernels(SimdLevel level) {
	if (level == SimdLevel::avx2 && best_simd_level() == SimdLevel::avx2) {
		return *avx2_kernel_set();
	}
	return *baseline_kernel_set();
}

} // namespace undergrowth

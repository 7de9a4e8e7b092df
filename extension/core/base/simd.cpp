#include "base/simd.hpp"

#if defined(__x86_64__) || defined(__i386__) || defined(_M_X64) || defined(_M_IX86)
#define UNDERGROWTH_X86
#if defined(_MSC_VER)
#include <immintrin.h>
#include <intrin.h>
#else
#include <cpuid.h>
#endif
#endif

namespace undergrowth {

namespace {

#if defined(UNDERGROWTH_X86)

struct Registers {
	unsigned int a, b, c, d;
};

// Uses CPUID directly: __builtin_cpu_supports needs a table that the runtimes of some compilers lack.
Registers cpuid(unsigned int leaf) {
#if defined(_MSC_VER)
	int values[4];
	__cpuidex(values, static_cast<int>(leaf), 0);
	return { static_cast<unsigned int>(values[0]), static_cast<unsigned int>(values[1]),
		static_cast<unsigned int>(values[2]), static_cast<unsigned int>(values[3]) };
#else
	Registers registers;
	__cpuid_count(leaf, 0, registers.a, registers.b, registers.c, registers.d);
	return registers;
#endif
}

/// Registers that the operating system saves (the low half of XCR0).
unsigned int saved_registers() {
#if defined(_MSC_VER)
	return static_cast<unsigned int>(_xgetbv(0));
#else
	unsigned int low;
	unsigned int high;
	__asm__ volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
	return low;
#endif
}

/// True if the processor has AVX2 and half floats (which came before it), and the operating system saves its registers
/// (Intel's manual, volume 1, 14.3).
bool processor_has_avx2() {
	constexpr unsigned int OSXSAVE_AVX_AND_F16C = (1u << 27) | (1u << 28) | (1u << 29);
	constexpr unsigned int AVX2 = 1u << 5;
	constexpr unsigned int XMM_AND_YMM = 6u;
	if (cpuid(0).a < 7u || (cpuid(1).c & OSXSAVE_AVX_AND_F16C) != OSXSAVE_AVX_AND_F16C) {
		return false;
	}
	return (saved_registers() & XMM_AND_YMM) == XMM_AND_YMM && (cpuid(7).b & AVX2) != 0u;
}

#else

bool processor_has_avx2() {
	return false;
}

#endif

} // namespace

SimdLevel best_simd_level() {
	static const SimdLevel best = processor_has_avx2() ? SimdLevel::avx2 : SimdLevel::baseline;
	return best;
}

} // namespace undergrowth

#pragma once

namespace undergrowth {

/// Which build of the kernels runs. All give the same bits.
///
/// Kernels are files named kernels_*.cpp, each set beside what it belongs to (wind/, motion/). How to compile (GCC and
/// clang; MSVC in brackets):
/// - all of the core: -ffp-contract=off;
/// - kernels_baseline.cpp: -O3 -fno-math-errno -fno-trapping-math besides [/O2];
/// - kernels_avx2.cpp: the same and, on x86 only, -mavx2 -mf16c without -mfma [/O2 /arch:AVX2]. Without it the file is
///   empty and every level is the baseline.
enum class SimdLevel {
	baseline, ///< What the library is compiled for: SSE2 on any x86-64, NEON on any arm64.
	avx2,
};

/// The best that this processor can run, looked up once.
SimdLevel best_simd_level();

} // namespace undergrowth

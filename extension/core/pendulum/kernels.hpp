#pragma once

namespace undergrowth {

/// Which build of the kernels runs. All give the same bits.
///
/// How to compile (GCC and clang; MSVC in brackets):
/// - all of the core: -ffp-contract=off;
/// - pendulum/kernels_baseline.cpp: -O3 -fno-math-errno -fno-trapping-math besides [/O2];
/// - pendulum/kernels_avx2.cpp: the same and, on x86 only, -mavx2 -mf16c without -mfma [/O2 /arch:AVX2]. Without it
/// this
///   file is empty and every level is the baseline.
enum class SimdLevel {
	baseline, ///< What the library is compiled for (SSE2 on any x86-64).
	avx2,
};

/// The best that this processor and this build can run, looked up once.
SimdLevel best_simd_level();

} // namespace undergrowth

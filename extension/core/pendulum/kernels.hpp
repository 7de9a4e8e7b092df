#pragma once

namespace undergrowth {

/// Which build of the kernels runs. All give the same bits.
enum class SimdLevel {
	baseline, ///< What the library is compiled for (SSE2 on any x86-64).
	avx2,
};

/// The best that this processor can run, looked up once.
SimdLevel best_simd_level();

} // namespace undergrowth

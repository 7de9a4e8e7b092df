// Compiled with AVX2 enabled (base/simd.hpp). Without AVX2 this level does not exist and the baseline is used.
#include "wind/wind_kernels.hpp"

#if defined(__AVX2__)

#include <immintrin.h>
#if !defined(__GNUC__)
#include <math.h>
#include <string.h>
#pragma fp_contract(off)
#endif

namespace undergrowth {

namespace avx2_kernels {

#include "base/kernel_basics.inc"
#include "wind/kernel_air.inc"
#include "wind/kernel_air_ahead.inc"
#include "wind/kernel_wind.inc"

static const WindKernels SET = { sample_wind, sample_turbulence, sample_waves, make_velocities, keep_samples,
	between_samples, make_isolated_velocities };

} // namespace avx2_kernels

const WindKernels *avx2_wind_kernels() {
	return &avx2_kernels::SET;
}

} // namespace undergrowth

#else

namespace undergrowth {

const WindKernels *avx2_wind_kernels() {
	return nullptr;
}

} // namespace undergrowth

#endif

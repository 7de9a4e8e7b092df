#include "wind/wind_kernels.hpp"

#if defined(__SSE2__) || defined(_M_X64)
#include <emmintrin.h>
#elif defined(__aarch64__) && defined(__GNUC__)
#include <arm_neon.h>
#define UNDERGROWTH_NEON
#endif
#if !defined(__GNUC__)
#include <math.h>
#include <string.h>
#pragma fp_contract(off)
#endif

namespace undergrowth {

namespace baseline_kernels {

#include "base/kernel_basics.inc"
#include "wind/kernel_air.inc"
#include "wind/kernel_air_ahead.inc"
#include "wind/kernel_wind.inc"

static const WindKernels SET = { sample_wind, sample_turbulence, sample_waves, make_velocities, keep_samples,
	between_samples, make_isolated_velocities };

} // namespace baseline_kernels

const WindKernels *baseline_wind_kernels() {
	return &baseline_kernels::SET;
}

} // namespace undergrowth

#include "pendulum/kernel_tables.hpp"

#if !defined(__GNUC__)
#include <math.h>
#include <string.h>
#pragma fp_contract(off)
#endif

namespace undergrowth {

namespace baseline_kernels {

#include "pendulum/kernel_bodies.inc"

static const KernelSet SET = { step_elasticity, step_spring, step_elasticity_page, step_spring_page, sample_wind,
	encode_elasticity, encode_spring, interpolate_elasticity, interpolate_spring };

} // namespace baseline_kernels

const KernelSet *baseline_kernel_set() {
	return &baseline_kernels::SET;
}

} // namespace undergrowth

#include "pendulum/kernel_tables.hpp"

#if !defined(__GNUC__)
#include <math.h>
#pragma fp_contract(off)
#endif

namespace undergrowth {

namespace baseline_kernels {

#include "pendulum/kernel_bodies.inc"

static const KernelSet SET = { step_elasticity, step_spring, interpolate_elasticity, interpolate_spring };

} // namespace baseline_kernels

const KernelSet *baseline_kernel_set() {
	return &baseline_kernels::SET;
}

} // namespace undergrowth

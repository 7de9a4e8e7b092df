#include "motion/kernel_tables.hpp"

#if defined(__aarch64__) && defined(__GNUC__)
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
#include "motion/kernel_bends.inc"
#include "motion/kernel_elasticity.inc"
#include "motion/kernel_loads.inc"
#include "motion/kernel_over_ground.inc"
#include "motion/kernel_spring.inc"
#include "motion/kernel_stem.inc"
#include "motion/kernel_stem_bodies.inc"
#include "motion/kernel_weight.inc"

static const KernelSet SET = { step_elasticity, step_spring, step_elasticity_in_air, step_spring_in_air, step_stem,
	lift_stems, weigh_stems, move_calm, find_near_stems, measure_stem, encode_elasticity, encode_spring, encode_stem,
	interpolate_elasticity, interpolate_spring };

} // namespace baseline_kernels

const KernelSet *baseline_kernel_set() {
	return &baseline_kernels::SET;
}

} // namespace undergrowth

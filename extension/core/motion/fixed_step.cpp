#include "motion/fixed_step.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

/// Share of a step that may be missing from a whole one. A frame may last exactly one step, or twelve frames of 1/144 s
/// five steps of 1/60 s. Such a frame must not wait for the next one because a sum was rounded down.
constexpr double ROUNDING = 1e-6;
constexpr int MIN_STEPS = 2; // Steps that a frame can catch up, so that a step as long as a frame is never missing.

int steps_of_frame(double step) {
	return std::max(static_cast<int>(std::ceil(FixedStep::LONGEST_FRAME / step - ROUNDING)), MIN_STEPS);
}

} // namespace

FixedStep::FixedStep(double step, int max_steps) : step_length(step), step_limit(max_steps) {}

FixedStep::FixedStep(double step) : FixedStep(step, steps_of_frame(step)) {}

int FixedStep::advance(double delta) {
	if (!std::isfinite(delta) || delta < 0.0) {
		return 0;
	}
	left += delta;
	const double due = std::floor(left / step_length + ROUNDING);
	if (due > static_cast<double>(step_limit)) {
		left = 0.0;
		return step_limit;
	}
	left -= due * step_length;
	return static_cast<int>(due);
}

float FixedStep::alpha() const {
	const double part = left / step_length;
	return static_cast<float>(part < 0.0 ? 0.0 : (part > 1.0 ? 1.0 : part));
}

double FixedStep::step() const {
	return step_length;
}

} // namespace undergrowth

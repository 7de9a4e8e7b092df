#pragma once

#include <cstdint>

namespace undergrowth {

/// A time (s) that advances in steps. It is a product and not a sum: the same steps give the same bits for any grouping
/// into frames, and no rounding error grows.
struct StepTime {
	double start = 0.0; ///< s.
	int64_t count = 0; ///< Steps since `start`.
	double length = 0.0; ///< s, of a step.

	double now() const { return start + static_cast<double>(count) * length; }
	/// Returns the time `ago` steps of `step` seconds before now().
	double before(int ago, double step) const {
		return step == length ? start + static_cast<double>(count - ago) * length : now() - ago * step;
	}
	/// Returns the time one step of `step` seconds later.
	StepTime next(double step) const {
		return step == length ? StepTime{ start, count + 1, length } : StepTime{ now(), 1, step };
	}
	/// Returns the time `seconds`, with earlier steps of the same length.
	StepTime moved_to(double seconds) const { return { seconds, 0, length }; }
};

} // namespace undergrowth

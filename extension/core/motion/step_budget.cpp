#include "motion/step_budget.hpp"

#include <algorithm>

namespace undergrowth {

void StepBudget::record(double seconds) {
	last_but_one = last;
	last = seconds;
}

int StepBudget::allow(int due) const {
	const double step = std::min(last, last_but_one);
	if (step * due <= MAX_TIME) {
		return due;
	}
	return std::min(due, 1 + static_cast<int>(MAX_TIME / step));
}

} // namespace undergrowth

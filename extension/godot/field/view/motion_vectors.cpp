#include "field/view/motion_vectors.hpp"

#include <utility>

namespace undergrowth {

MotionVectors::Sent MotionVectors::next(const Shown &now, bool is_wanted) {
	const Shown last = std::exchange(before, now);
	if (!std::exchange(has_before, is_wanted) || !is_wanted) {
		sent = is_wanted ? Sent{ TILT, now.clock, 0.0f } : Sent();
		return sent;
	}
	const double steps = now.steps - last.steps;
	if (steps == 0.0) {
		sent.clock = now.clock;
		sent.steps = 0.0f;
		return sent;
	}
	const bool is_jump = steps < 0.0 || steps > MAX_STEPS;
	sent = { -sent.tilt, is_jump ? now.clock : last.clock, is_jump ? 0.0f : float(steps) };
	return sent;
}

} // namespace undergrowth

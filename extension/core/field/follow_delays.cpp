#include "field/follow_delays.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

FollowDelays::FollowDelays(float step) :
		max_steps(std::max(static_cast<int>(std::lround(GOING_OVER / step)), 1)), steps(max_steps + 1) {}

void FollowDelays::set(const DelayPlane &plane) {
	old_plane = new_plane = wanted = plane;
	steps = max_steps + 1;
}

void FollowDelays::step() {
	steps = std::min(steps + 1, max_steps + 1);
	if (steps > max_steps && wanted != new_plane) {
		old_plane = new_plane;
		new_plane = wanted;
		steps = 1;
	}
}

float FollowDelays::share(float fraction) const {
	const float gone = static_cast<float>(steps - 1) + fraction;
	return glm::smoothstep(0.0f, 1.0f, gone / static_cast<float>(max_steps)); // Without a jerk at either end.
}

} // namespace undergrowth

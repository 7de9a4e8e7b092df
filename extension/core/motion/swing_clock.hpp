#pragma once

#include "plant/part_motion.hpp"

#include <cmath>

namespace undergrowth {

/// Clock of swinging parts. It advances with the steps of the motion, so parts of plants that do not step are still.
class SwingClock {
public:
	void step(double seconds) {
		last = seconds;
		time = std::fmod(time + seconds, SWING_PERIOD);
	}
	/// `alpha` of the way of the last step: StemMotion::clock.
	float now(float alpha) const {
		const double share = (time + (static_cast<double>(alpha) - 1.0) * last) / SWING_PERIOD;
		return static_cast<float>(share - std::floor(share));
	}

private:
	double time = 0.0; ///< s, at the end of the last step.
	double last = 0.0; ///< s, its length.
};

} // namespace undergrowth

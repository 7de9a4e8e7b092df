#pragma once

#include <cstdint>

namespace undergrowth {

/// The steps of a frame, the same for all plants, fields and winds.
struct FrameSteps {
	uint64_t frame = 0; ///< Number of the frame; the first is 1.
	int count = 0;
	double length = 1.0 / 60.0; ///< s.
	/// Position of the frame between the last but one step (0) and the last one (1).
	float alpha = 0.0f;

	/// Returns the time (s) from the end of step `index`, 0 to count - 1, to this frame.
	double ago(int index) const { return length * (double(alpha) + count - 1 - index); }
};

} // namespace undergrowth

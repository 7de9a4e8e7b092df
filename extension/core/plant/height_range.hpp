#pragma once

namespace undergrowth {

/// Heights that a species grows to, uniform in [min, max).
struct HeightRange {
	float min = 1.0f; ///< m, > 0.
	float max = 2.0f; ///< m, > min.

	/// The height at `share` of the way, a random number in [0, 1).
	constexpr float at(float share) const { return min + (max - min) * share; }
};

} // namespace undergrowth

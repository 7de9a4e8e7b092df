#pragma once

#include <vector>

namespace undergrowth {

/// Suitability as a function of one number: linear between evenly spaced values, and constant beyond their ends.
struct HabitatCurve {
	float low = 0.0f; ///< Of the first value.
	float high = 1.0f; ///< Of the last value, above `low`.
	std::vector<float> values; ///< 0 to 1, two or more. Empty: 1 everywhere.

	bool is_set() const { return !values.empty(); }
	float at(float x) const;
};

} // namespace undergrowth

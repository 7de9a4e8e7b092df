#pragma once

namespace undergrowth {

/// Heights that a species grows to, uniform in [min, max).
struct HeightRange {
	float min = 1.0f; ///< m, > 0.
	float max = 2.0f; ///< m, > min.
};

} // namespace undergrowth

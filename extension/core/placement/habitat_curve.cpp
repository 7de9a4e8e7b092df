#include "placement/habitat_curve.hpp"

#include <algorithm>
#include <cstddef>

namespace undergrowth {

float HabitatCurve::at(float x) const {
	if (values.empty()) {
		return 1.0f;
	}
	const auto last = static_cast<float>(values.size() - 1);
	const float share = (x - low) / (high - low);
	const float place = share > 0.0f ? std::min(share, 1.0f) * last : 0.0f; // NaN is at the low end.
	const auto before = std::min(static_cast<std::size_t>(place), values.size() - 1);
	const std::size_t after = std::min(before + 1, values.size() - 1);
	return values[before] + (values[after] - values[before]) * (place - static_cast<float>(before));
}

} // namespace undergrowth

#include "wind/precipitation.hpp"

#include <cmath>

namespace undergrowth {

float drop_chance(const Precipitation &precipitation) {
	// 1 mm/h of drops of 2 mm is 70 drops per m² and second. One in seven is large enough to move a leaf.
	constexpr float DROPS = 0.02f; // Per second and mm/h.
	return precipitation.rain > 0.0f ? 1.0f - std::exp(-DROPS * precipitation.rain) : 0.0f;
}

} // namespace undergrowth

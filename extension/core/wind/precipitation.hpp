#pragma once

namespace undergrowth {

/// Water and snow on plants. Both from 0 to 1.
struct Precipitation {
	float wetness = 0.0f; ///< 1: the surface of each leaf has as much water as it can hold.
	float snow = 0.0f; ///< 1: plants carry as much snow as they can hold.

	bool is_none() const { return wetness == 0.0f && snow == 0.0f; }
	bool operator==(const Precipitation &other) const { return wetness == other.wetness && snow == other.snow; }
	bool operator!=(const Precipitation &other) const { return !(*this == other); }
};

} // namespace undergrowth

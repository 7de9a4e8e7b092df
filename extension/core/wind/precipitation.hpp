#pragma once

namespace undergrowth {

/// Water and snow on plants, and rain that falls.
struct Precipitation {
	float wetness = 0.0f; ///< 0 to 1. 1: the surface of each leaf has as much water as it can hold.
	float snow = 0.0f; ///< 0 to 1. 1: plants carry as much snow as they can hold.
	float rain = 0.0f; ///< mm/h. Drops hit leaves.

	bool has_load() const { return wetness != 0.0f || snow != 0.0f; }
	bool operator==(const Precipitation &other) const {
		return wetness == other.wetness && snow == other.snow && rain == other.rain;
	}
	bool operator!=(const Precipitation &other) const { return !(*this == other); }
};

/// Chance that one of the few large drops hits a leaf of 20 cm² within a second, 0 to 1.
float drop_chance(const Precipitation &precipitation);

} // namespace undergrowth

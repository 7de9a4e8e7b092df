#include "wind/wind.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"

#include <cmath>

namespace undergrowth {

namespace {

/// Fractional part of `value`, in [0, 1) in spite of rounding.
double fraction(double value) {
	const double part = value - std::floor(value);
	return part < 1.0 ? part : 0.0;
}

/// Phase of the wind, in cycles from 0 to 1. Doubles stay precise for hours.
double cycle_at(const Wind &wind, double time) {
	return fraction(static_cast<double>(wind.frequency) * time + wind.phase);
}

bool gust_blows(const Wind &wind, double time) {
	const double since = time - wind.gust_start;
	return since >= 0.0 && since < static_cast<double>(gust_duration(wind));
}

float steady_strength(const Wind &wind, double time) {
	switch (wind.kind) {
		case WindKind::constant:
			return wind.strength;
		case WindKind::bursts:
			return cycle_at(wind, time) < 0.5 ? wind.strength : 0.0f;
		case WindKind::waves:
			return wind.strength * static_cast<float>(1.0 + portable_sin(2.0 * PI * cycle_at(wind, time)));
		case WindKind::gust:
		case WindKind::air:
			break;
	}
	return 0.0f;
}

} // namespace

float gust_strength(const Wind &wind) {
	if (wind.gust_triggered) {
		return wind.triggered_strength < 0.0f ? wind.strength : wind.triggered_strength;
	}
	return wind.kind == WindKind::gust ? wind.strength : 0.0f;
}

float gust_duration(const Wind &wind) {
	return wind.gust_triggered && !(wind.triggered_duration < 0.0f) ? wind.triggered_duration : wind.gust_duration;
}

float wind_strength(const Wind &wind, double time) {
	const float gust = gust_blows(wind, time) ? gust_strength(wind) : 0.0f;
	return steady_strength(wind, time) + gust;
}

glm::vec3 wind_direction(const Wind &wind) {
	const double angle = static_cast<double>(wind.direction);
	return { static_cast<float>(portable_sin(angle)), 0.0f, static_cast<float>(portable_cos(angle)) };
}

glm::vec3 wind_force(const Wind &wind, double time) {
	return wind_direction(wind) * wind_strength(wind, time);
}

void change_frequency(Wind &wind, float frequency, double time) {
	wind.phase = fraction(cycle_at(wind, time) - static_cast<double>(frequency) * time);
	wind.frequency = frequency;
}

} // namespace undergrowth

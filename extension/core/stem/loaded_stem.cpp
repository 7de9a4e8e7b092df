#include "stem/loaded_stem.hpp"

#include "conventions.hpp"
#include "wind/air_profile.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float STEPS = 64.0f;

float rounded_share(float share) {
	return std::isfinite(share) ? std::round(std::clamp(share, 0.0f, 1.0f) * STEPS) / STEPS : 0.0f;
}

/// m: kg of the load per kg/m of StemMode::air_drag, half the air's density times the drag area.
float mass_by_air(const Precipitation &load) {
	const float mass = WATER_PER_DRAG_AREA * load.wetness + SNOW_PER_DRAG_AREA * load.snow;
	return mass / (0.5f * AIR_DENSITY);
}

} // namespace

Precipitation rounded(const Precipitation &precipitation) {
	return { rounded_share(precipitation.wetness), rounded_share(precipitation.snow), 0.0f };
}

StemConstants loaded_stem(const StemConstants &stem, const Precipitation &load) {
	StemConstants loaded = stem;
	const float mass = mass_by_air(load);
	const float drag = 1.0f + (SNOW_DRAG - 1.0f) * load.snow;
	for (StemMode &mode : loaded.mode) {
		const float own = mode.mass;
		mode.mass = own + mass * mode.air_drag;
		const float pace = std::sqrt(own / mode.mass);
		mode.frequency *= pace;
		mode.damping *= pace;
		mode.air_drag *= drag;
	}
	loaded.air_slope *= drag;
	loaded.drag_area *= drag;
	return loaded;
}

float slope_of_load(const StemConstants &stem, const Precipitation &load) {
	return stem.air_slope * STANDARD_GRAVITY * mass_by_air(load);
}

} // namespace undergrowth

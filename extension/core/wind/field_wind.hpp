#pragma once

#include "wind/air.hpp"
#include "wind/precipitation.hpp"
#include "wind/wind.hpp"
#include "wind/wind_kernels.hpp"

#include <memory>

namespace undergrowth {

/// A wind that travels through a field. The wind at a plant (x, z) and `time` is `wind` at
/// time - dot((x, z), direction)/speed. Plants upwind of the origin are ahead of it, except for gusts: a gust that
/// starts now reaches all of them now.
struct FieldWind {
	Wind wind;
	float speed = 10.0f; ///< m/s. 0 or less, or not finite: no delay.
	float min_delay = 0.0f; ///< s, of gusts. Not 0 if `wind` is given at a position other than the origin.
	Air air = {}; ///< For WindKind::air.
	AirAxes axes = {}; ///< Of the positions.
	std::shared_ptr<const AirTiles> tiles = nullptr; ///< Null: no turbulence.
	Precipitation precipitation = {}; ///< The same everywhere.
};

/// Delay of the wind at (x, z) relative to the origin (s).
float wind_delay(const FieldWind &wind, float x, float z);

/// The wind at one time, in the form that the kernels read. Invalid numbers count as 0. A pure function.
WindSnapshot wind_at_time(const FieldWind &wind, double time);

/// The horizontal unit directions along and across the wind, without strengths.
PlantWinds winds_along(const FieldWind &wind);

/// Like wind_at_time(), with a precomputed winds_along(wind).
WindSnapshot wind_at_time(const FieldWind &wind, const PlantWinds &along, double time);

} // namespace undergrowth

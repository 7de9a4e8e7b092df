#pragma once

#include "wind/air.hpp"
#include "wind/wind.hpp"
#include "wind/wind_kernels.hpp"

#include <memory>

namespace undergrowth {

/// A wind that travels through a field: a plant at (x, z) feels at `time` what `wind` is at
/// time - dot((x, z), direction)/speed. The origin feels it as it is, plants upwind of the origin before it, but for
/// gusts: one that is let go now blows on all of them now, since nobody can have felt it before.
struct FieldWind {
	Wind wind;
	float speed = 10.0f; ///< m/s. 0, less, or not finite: everywhere at once.
	float least_delay = 0.0f; ///< s, of gusts. Not 0 where `wind` is told as it is at another place.
	Air air = {}; ///< Of WindKind::air.
	AirAxes axes = {}; ///< Of the places where it blows.
	std::shared_ptr<const AirTiles> tiles = nullptr; ///< Null: no turbulence.
};

/// How long after the origin the wind comes to (x, z) (s).
float wind_delay(const FieldWind &wind, float x, float z);

/// The wind at one time, ready for the kernels. Numbers that are none or out of range count as 0. A pure function.
TravellingWind wind_at_time(const FieldWind &wind, double time);

/// Where it blows to: the horizontal unit direction as PlantWinds::x and z and that across it, without strengths.
PlantWinds winds_along(const FieldWind &wind);

/// The same as wind_at_time() for who has winds_along(wind) already.
TravellingWind wind_at_time(const FieldWind &wind, const PlantWinds &along, double time);

} // namespace undergrowth

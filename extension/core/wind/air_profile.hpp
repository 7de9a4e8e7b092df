#pragma once

namespace undergrowth {

/// Wind speed and its variation by height. Heights and roughness are metres, speeds are relative to the speed at 10 m.
/// All results are finite and at least 0 for finite arguments.

inline constexpr float AIR_DENSITY = 1.225f; ///< kg/m³, at 15 °C.
inline constexpr double REFERENCE_HEIGHT = 10.0; ///< m, height of a weather report's speed.

/// Above open ground: ln(z/z0)/ln(10/z0), the logarithmic law. Below ten roughness lengths the speed falls to 0 in
/// proportion to the height.
double open_ground_speed(double height, double roughness);
/// Standard deviation along the wind, as a share of the speed at 10 m: 2.185 friction velocities at all heights above
/// ten roughness lengths (a quarter of the speed at 1 m over 0.03 m), and below in proportion to the height.
double open_ground_gusts(double height, double roughness);
/// Both functions for many heights above one ground.
class OpenGround {
public:
	explicit OpenGround(double roughness);
	double speed(double height) const;
	double gusts(double height) const;
	double eddies(double height) const;

	static constexpr double ROUGH_LAYER = 10.0; ///< Roughness lengths.
	double roughness() const { return rough; }
	/// Difference of the speed at two heights, divided by the logarithm of their ratio.
	double growth() const { return over_log; }

private:
	double rough; ///< m.
	double over_log; ///< 1/ln(10/z0).

	double share_of_layer(double height) const;
};

inline constexpr float TURF_HEIGHT = 0.01f; ///< m, of a canopy without a given height.

/// Speed at the top of a canopy, by the logarithmic law with a displacement of 0.7 and a roughness of 0.1 heights.
double canopy_top_speed(double canopy_height);
/// Speed at a height within a canopy: exponential below its top (extinction from 2, thin, to 4.4, dense), the
/// logarithmic law above.
double canopy_speed(double height, double canopy_height, double extinction = 2.5);
/// Standard deviation along the wind at the canopy's top, relative to the speed there: 1.9 friction velocities.
inline constexpr double CANOPY_GUSTS = 1.9 * 0.364;
/// Standard deviation along the wind at a height within a canopy or above it: falls below the top as canopy_speed(),
/// and is constant above.
double canopy_gusts(double height, double canopy_height, double extinction = 2.5);
/// Standard deviation across the wind, relative to that along it.
inline constexpr double SIDE_GUSTS = 0.75;

/// Standard deviation of the large eddies in turbulence of 1, from 0 to 1; the rest is small. It grows with the
/// height's logarithm, EDDIES_AT_ONE + EDDIES_GROWTH·ln(z/1 m), and is constant within ten roughness lengths.
inline constexpr double EDDIES_AT_ONE = 0.45;
inline constexpr double EDDIES_GROWTH = 0.235;
double open_ground_eddies(double height, double roughness);
/// Above a canopy: that of open ground at 2 m, so that gusts cross a meadow as a whole beside its waves.
inline constexpr double CANOPY_EDDIES = 0.626;

/// Beaufort's number from 0 to 12 of a speed at 10 m (m/s): nearest to U = 0.836·B^1.5.
int beaufort_of(double speed);
/// That speed (m/s).
double beaufort_speed(int number);

} // namespace undergrowth

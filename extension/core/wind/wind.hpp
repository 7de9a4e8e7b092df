#pragma once

#include <glm/vec3.hpp>

namespace undergrowth {

/// Kinds of wind: the four of the thesis (section 4.3, figures 4.3 to 4.6), and air.
enum class WindKind {
	gust, ///< Full strength for `gust_duration` from `gust_start` on, then nothing.
	constant, ///< Full strength, always.
	bursts, ///< Full strength in the first half of each period, nothing in the second.
	waves, ///< strength·(1 + sin(2π·phase)): from 0 to twice the strength.
	air, ///< A velocity, see FieldWind::air. Uses only direction and gusts of Wind, with strengths in m/s.
};

/// All values finite; strength, frequency and gust_duration >= 0.
struct Wind {
	WindKind kind = WindKind::constant;
	float strength = 10.0f; ///< N on a tip with wind weight 1.
	float direction = 0.0f; ///< rad; 0 blows towards +z, a quarter turn towards +x.
	float frequency = 0.5f; ///< Hz, of bursts and waves.
	float gust_duration = 0.5f; ///< s.
	double gust_start = 0.0; ///< s.
	bool gust_triggered = false; ///< Adds a triggered gust to any kind.
	float triggered_strength = -1.0f; ///< N, of that gust; below 0: `strength`.
	float triggered_duration = -1.0f; ///< s, of that gust; below 0: `gust_duration`.
	double phase = 0.0; ///< Cycles by which bursts and waves lead frequency·time.
};

/// Strength (N) and duration (s) of the gust at `gust_start`, if there is one.
float gust_strength(const Wind &wind);
float gust_duration(const Wind &wind);

/// The force's size (N) at `time` (s). A pure function.
float wind_strength(const Wind &wind, double time);

/// Direction towards which the wind blows: a horizontal unit vector.
glm::vec3 wind_direction(const Wind &wind);

/// The force (N) at `time` (s): direction times strength.
glm::vec3 wind_force(const Wind &wind, double time);

/// Changes the frequency at `time` without a jump of the wave. Sets frequency and phase, wrapped to [0, 1).
void change_frequency(Wind &wind, float frequency, double time);

} // namespace undergrowth

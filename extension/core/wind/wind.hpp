#pragma once

#include <glm/vec3.hpp>

namespace undergrowth {

/// How wind blows: the four ways of the thesis (section 4.3, figures 4.3 to 4.6), and as air does.
enum class WindKind {
	gust, ///< Full strength for `gust_duration` from `gust_start` on, then nothing.
	constant, ///< Full strength, always.
	bursts, ///< Full strength in the first half of each period, nothing in the second.
	waves, ///< strength·(1 + sin(2π·phase)): from 0 to twice the strength.
	air, ///< A velocity, by FieldWind::air; of what is here, direction and gusts only, whose strength is in m/s.
};

/// All values finite; strength, frequency and gust_duration >= 0.
struct Wind {
	WindKind kind = WindKind::constant;
	float strength = 10.0f; ///< N on a tip with wind weight 1.
	float direction = 0.0f; ///< rad; 0 blows towards +z, a quarter turn towards +x.
	float frequency = 0.5f; ///< Hz, of bursts and waves.
	float gust_duration = 0.5f; ///< s.
	double gust_start = 0.0; ///< s.
	bool gust_triggered = false; ///< A gust that somebody called for blows on top of the other kinds, too.
	float triggered_strength = -1.0f; ///< N, of that gust; below 0: `strength`.
	float triggered_duration = -1.0f; ///< s, of that gust; below 0: `gust_duration`.
	double phase = 0.0; ///< Cycles that bursts and waves are ahead of frequency·time.
};

/// How strong (N) and how long (s) the gust at `gust_start` is, if one blows at all.
float gust_strength(const Wind &wind);
float gust_duration(const Wind &wind);

/// The force's size (N) at `time` (s). A pure function.
float wind_strength(const Wind &wind, double time);

/// Where the wind blows to: a horizontal unit vector.
glm::vec3 wind_direction(const Wind &wind);

/// The force (N) at `time` (s): direction times strength.
glm::vec3 wind_force(const Wind &wind, double time);

/// Changes the frequency at `time` so that the wave goes on where it is: sets frequency and phase (kept in [0, 1)).
void change_frequency(Wind &wind, float frequency, double time);

} // namespace undergrowth

#pragma once

#include "form/part.hpp"

#include <algorithm>

namespace undergrowth {

// Tones that the add-on's material gives to the colours of a mesh: undergrowth_parts.gdshaderinc with its default
// values, and undergrowth_leaf.gdshaderinc. Mean colours of plants and their levels include them.

inline float smooth_step(float low, float high, float value) {
	const float t = std::clamp((value - low) / (high - low), 0.0f, 1.0f);
	return t * t * (3.0f - 2.0f * t);
}

/// Brightness by the visible fraction of the sky. The albedo is darker at the base: leaves in the shade of a sward are
/// old and covered with soil. Half of the light comes from the sky, and the sun's is less affected (shade_in_light).
inline float tone_of(float openness) {
	constexpr float BASE_TONE = 0.3f;
	constexpr float TIP_TONE = 1.2f;
	constexpr float SHADE = 0.7f; // Mean of 1 for the sky and 0.4 for the sun.
	const float tone = BASE_TONE + (TIP_TONE - BASE_TONE) * smooth_step(0.05f, 0.7f, openness);
	return tone * (1.0f - SHADE * (1.0f - openness));
}

/// Brightness of a point of a part with these veins. `base`: 1 at the part's base to 0 at its tip. Petals shade each
/// other at their base.
inline float petal_tone(Venation veins, float base) {
	return veins == Venation::radial ? 0.6f + 0.4f * smooth_step(0.0f, 0.4f, 1.0f - base) : 1.0f;
}

} // namespace undergrowth

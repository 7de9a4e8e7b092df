#include "stem/stem_ground.hpp"

#include "stem/stem_bones.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float MAX_BEND = 3.0f;
constexpr float STEP = 0.05f; // Tips descend so evenly that none passes the ground and returns within it.
constexpr int HALVINGS = 16;
/// Second mode beyond that of a steady wind, as blows and pushes excite it.
constexpr float SECONDS[] = { -0.5f, -0.25f, 0.25f, 0.5f };

/// Bend of the tip, in the shape of a steady wind, at which it reaches the ground. `second` is the additional second
/// mode.
float bend_on_ground(const StemConstants &stem, float more) {
	const auto is_above = [&](float bend) {
		const float first = stem.mode[0].dead_share * bend;
		const float second = stem.modes == 2 ? stem.mode[1].dead_share * bend + more : 0.0f;
		const glm::vec2 amplitudes[MAX_STEM_MODES] = { { first, 0.0f }, { second, 0.0f } };
		return stem_place(stem, amplitudes, 1.0f).centre.y > GROUND_HEIGHT;
	};
	float above = 0.0f;
	while (above < MAX_BEND && is_above(above + STEP)) {
		above += STEP;
	}
	float below = above + STEP;
	for (int i = 0; i < HALVINGS; i++) {
		const float middle = 0.5f * (above + below);
		(is_above(middle) ? above : below) = middle;
	}
	return below;
}

} // namespace

StemChords chords_of(const StemConstants &stem) {
	StemChords chords;
	const float alone = bend_on_ground(stem, 0.0f);
	chords.first = 1.0f / (alone * stem.mode[0].dead_share);
	if (stem.modes == 2) {
		for (const float more : SECONDS) {
			const float taken = 1.0f - bend_on_ground(stem, more) / alone;
			chords.second = std::max(chords.second, taken / std::fabs(more));
		}
	}
	return chords;
}

} // namespace undergrowth

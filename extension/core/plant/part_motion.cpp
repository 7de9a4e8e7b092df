#include "plant/part_motion.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr int STEPS = 16; // Of each octave.
constexpr int OCTAVES = 8;
constexpr int DAMPINGS = 32;
constexpr float MAX_DAMPING = 2.0f;
constexpr int PHASES = 32;
constexpr int SIDES = 31;
constexpr int ROOMS = 4;
constexpr float MIN_ROOM = 0.02f;
constexpr float MORE_ROOM = 4.0f;
constexpr int LOWEST = -2048; // Halves represent whole numbers exactly from here to 2048.

int nearest(float value) {
	return static_cast<int>(std::floor(value + 0.5f));
}

int pace_of(float frequency) {
	float swings = std::max(frequency, 0.0f) * static_cast<float>(SWING_PERIOD);
	int octave = 0;
	while (octave < OCTAVES - 1 && swings > static_cast<float>(2 * STEPS) - 0.5f) {
		swings *= 0.5f;
		octave++;
	}
	return STEPS * octave + std::clamp(nearest(std::min(swings, 1e3f)) - STEPS, 0, STEPS - 1);
}

int side_of(const glm::vec2 &side) {
	if (side.x == 0.0f && side.y == 0.0f) {
		return 0;
	}
	const double turn = portable_atan2(side.y, side.x) / (2.0 * PI);
	const int step = nearest(static_cast<float>(turn * SIDES));
	return 1 + (step + SIDES) % SIDES;
}

/// The largest code with a room that is not larger.
int room_of(float room) {
	int step = 0;
	for (float next = MIN_ROOM * MORE_ROOM; step < ROOMS - 1 && next <= room; next *= MORE_ROOM) {
		step++;
	}
	return step;
}

} // namespace

PartMotionCode encode_part_motion(const PartMotion &swing) {
	const float share = std::sqrt(std::clamp(swing.damping_ratio, 0.0f, MAX_DAMPING) / MAX_DAMPING);
	const int damping = nearest(share * (DAMPINGS - 1));
	const float turns = swing.phase - std::floor(swing.phase);
	const int phase = nearest(turns * PHASES) % PHASES;
	return { static_cast<float>(LOWEST + DAMPINGS * pace_of(swing.frequency) + damping),
		static_cast<float>(LOWEST + ((phase << 5) + side_of(swing.side)) * ROOMS + room_of(swing.room)) };
}

PartMotion decode_part_motion(const PartMotionCode &code) {
	const int pace = static_cast<int>(code.pace) - LOWEST;
	const int place = static_cast<int>(code.place) - LOWEST;
	const float damping = static_cast<float>(pace % DAMPINGS) / (DAMPINGS - 1);
	const int step = pace / DAMPINGS;
	const float swings = static_cast<float>((STEPS + step % STEPS) << (step / STEPS));
	PartMotion swing;
	swing.frequency = swings / static_cast<float>(SWING_PERIOD);
	swing.damping_ratio = MAX_DAMPING * damping * damping;
	swing.phase = static_cast<float>(place >> 7) / PHASES;
	const int side = (place >> 2) & SIDES;
	swing.room = MIN_ROOM * static_cast<float>(1 << (2 * (place % ROOMS)));
	if (side > 0) {
		const double turn = 2.0 * PI * (side - 1) / SIDES;
		swing.side = { static_cast<float>(portable_cos(turn)), static_cast<float>(portable_sin(turn)) };
	}
	return swing;
}

} // namespace undergrowth

#include "placement/curve_key.hpp"

#include <array>

namespace undergrowth {

namespace {

constexpr uint32_t STEP_BITS = 4; ///< Bits per coordinate that one table lookup resolves.
constexpr uint32_t STEP_PLACES = 1u << STEP_BITS;

/// Orientation of the curve within a square, relative to the whole.
struct Turn {
	bool is_swapped = false;
	bool is_flipped = false;

	constexpr uint32_t number() const { return (is_swapped ? 2u : 0u) + (is_flipped ? 1u : 0u); }
};

/// The steps to a square within one that is STEP_PLACES squares wide.
struct Step {
	uint8_t key = 0;
	uint8_t turn = 0; ///< Within that square.
};

constexpr Step way_to(uint32_t column, uint32_t row, Turn turn) {
	uint32_t key = 0;
	for (uint32_t side = STEP_PLACES / 2; side != 0; side /= 2) {
		const bool right = (((turn.is_swapped ? row : column) & side) != 0) != turn.is_flipped;
		const bool upper = (((turn.is_swapped ? column : row) & side) != 0) != turn.is_flipped;
		key = 4 * key + ((right ? 3u : 0u) ^ (upper ? 1u : 0u));
		if (!upper) {
			// The curve within the two lower quarters is turned.
			turn = { !turn.is_swapped, turn.is_flipped != right };
		}
	}
	return { static_cast<uint8_t>(key), static_cast<uint8_t>(turn.number()) };
}

constexpr std::size_t step_index(uint32_t turn, uint32_t column, uint32_t row) {
	return (turn * STEP_PLACES + column) * STEP_PLACES + row;
}

constexpr auto list_steps() {
	std::array<Step, 4 * STEP_PLACES * STEP_PLACES> steps = {};
	for (uint32_t turn = 0; turn < 4; turn++) {
		for (uint32_t column = 0; column < STEP_PLACES; column++) {
			for (uint32_t row = 0; row < STEP_PLACES; row++) {
				steps[step_index(turn, column, row)] = way_to(column, row, { turn >= 2, turn % 2 == 1 });
			}
		}
	}
	return steps;
}

constexpr auto STEPS = list_steps();

} // namespace

uint64_t curve_key(int column, int row) {
	constexpr uint32_t MIDDLE = 0x80000000u;
	const uint32_t x = static_cast<uint32_t>(column) + MIDDLE;
	const uint32_t y = static_cast<uint32_t>(row) + MIDDLE;
	uint64_t key = 0;
	uint32_t turn = 0;
	for (uint32_t place = 32; place > 0; place -= STEP_BITS) {
		const uint32_t shift = place - STEP_BITS;
		const Step &step = STEPS[step_index(turn, (x >> shift) % STEP_PLACES, (y >> shift) % STEP_PLACES)];
		key = (key << (2 * STEP_BITS)) + step.key;
		turn = step.turn;
	}
	return key;
}

} // namespace undergrowth

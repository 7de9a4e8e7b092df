#include "stand/curve_key.hpp"

namespace undergrowth {

uint64_t curve_key(int column, int row) {
	constexpr uint32_t MIDDLE = 0x80000000u;
	uint32_t x = static_cast<uint32_t>(column) + MIDDLE;
	uint32_t y = static_cast<uint32_t>(row) + MIDDLE;
	uint64_t key = 0;
	for (uint32_t side = MIDDLE; side != 0; side >>= 1) {
		const bool right = (x & side) != 0;
		const bool upper = (y & side) != 0;
		key = 4 * key + ((right ? 3u : 0u) ^ (upper ? 1u : 0u));
		if (!upper) {
			// The curve within the two lower quarters is turned.
			const uint32_t flip = right ? 0xffffffffu : 0u;
			const uint32_t turned = x ^ flip;
			x = y ^ flip;
			y = turned;
		}
	}
	return key;
}

} // namespace undergrowth

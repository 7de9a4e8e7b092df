#include "placement/clump.hpp"

#include "base/random.hpp"
#include "conventions.hpp"
#include "placement/cell_noise.hpp"

#include <cmath>

namespace undergrowth {

namespace {

constexpr double JITTER = 0.35; ///< Max distance of a centre from the middle of its cell, in cells.
constexpr double MEAN_TURN = 0.5 * PI; ///< rad.
constexpr double FLOW_SIZE = 10.0; ///< m.
constexpr double FLOW_TURN = 0.25 * PI; ///< rad, of the flow to both sides of its mean direction.
constexpr double OWN_TURN = 0.25; ///< rad, of a clump to both sides of the flow.
constexpr double MIN_LEAN = 0.4;

/// Byte `part` of the bits, in [0, 1).
double unit8(uint32_t bits, int part) {
	return static_cast<double>((bits >> (8 * part)) & 0xff) * (1.0 / 256.0);
}

} // namespace

Clump clump_at(double x, double z) {
	const double at_x = x / Clump::SPACING - 0.5;
	const double at_z = z / Clump::SPACING - 0.5;
	double nearest = 9.0;
	uint32_t own = 0;
	for (int i = 0; i < 4; i++) {
		const double column = std::floor(at_x) + (i & 1);
		const double row = std::floor(at_z) + (i >> 1);
		const uint32_t bits = noise_bits(static_cast<int>(column), static_cast<int>(row));
		const double dx = column + 2.0 * JITTER * (unit8(bits, 0) - 0.5) - at_x;
		const double dz = row + 2.0 * JITTER * (unit8(bits, 1) - 0.5) - at_z;
		const double square = dx * dx + dz * dz;
		if (square < nearest) {
			nearest = square;
			own = bits;
		}
	}
	const uint64_t kind = mix_bits(own);
	Clump clump;
	clump.turn = MEAN_TURN + FLOW_TURN * smooth_noise(x / FLOW_SIZE, z / FLOW_SIZE) +
			OWN_TURN * (2.0 * unit16(kind, 0) - 1.0);
	clump.lean = MIN_LEAN + (1.0 - MIN_LEAN) * unit16(kind, 1);
	clump.height = 2.0 * unit16(kind, 2) - 1.0;
	return clump;
}

} // namespace undergrowth

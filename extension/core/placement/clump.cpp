#include "placement/clump.hpp"

#include "base/random.hpp"
#include "conventions.hpp"

#include <cmath>

namespace undergrowth {

namespace {

constexpr double JITTER = 0.35; ///< Max distance of a centre from the middle of its cell, in cells.
constexpr double MEAN_TURN = 0.5 * PI; ///< rad.
constexpr double FLOW_SIZE = 10.0; ///< m.
constexpr double FLOW_TURN = 0.25 * PI; ///< rad, of the flow to both sides of its mean direction.
constexpr double OWN_TURN = 0.25; ///< rad, of a clump to both sides of the flow.
constexpr double MIN_LEAN = 0.4;

/// Equal to undergrowth_cell_hash() of the shaders.
uint32_t hash_cell(int column, int row) {
	uint32_t bits =
			static_cast<uint32_t>(column) * 0x9e3779b1u ^ (static_cast<uint32_t>(row) * 0x85ebca77u + 0xc2b2ae3du);
	bits = (bits ^ (bits >> 15)) * 0x2c1b3c6du;
	bits = (bits ^ (bits >> 12)) * 0x297a2d39u;
	return bits ^ (bits >> 15);
}

/// Byte `part` of the bits, in [0, 1).
double unit8(uint32_t bits, int part) {
	return static_cast<double>((bits >> (8 * part)) & 0xff) * (1.0 / 256.0);
}

/// Smooth noise from -1 to 1 with one cell per unit.
double flow_noise(double x, double z) {
	const double column = std::floor(x);
	const double row = std::floor(z);
	const auto corner = [&](int i, int j) {
		const uint32_t bits = hash_cell(static_cast<int>(column) + i, static_cast<int>(row) + j);
		return static_cast<double>(bits) * (2.0 / 4294967296.0) - 1.0;
	};
	const auto smooth = [](double share) { return share * share * (3.0 - 2.0 * share); };
	const double across = smooth(x - column);
	const double along = smooth(z - row);
	const double low = corner(0, 0) + (corner(1, 0) - corner(0, 0)) * across;
	const double high = corner(0, 1) + (corner(1, 1) - corner(0, 1)) * across;
	return low + (high - low) * along;
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
		const uint32_t bits = hash_cell(static_cast<int>(column), static_cast<int>(row));
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
	clump.turn =
			MEAN_TURN + FLOW_TURN * flow_noise(x / FLOW_SIZE, z / FLOW_SIZE) + OWN_TURN * (2.0 * unit16(kind, 0) - 1.0);
	clump.lean = MIN_LEAN + (1.0 - MIN_LEAN) * unit16(kind, 1);
	clump.height = 2.0 * unit16(kind, 2) - 1.0;
	return clump;
}

} // namespace undergrowth

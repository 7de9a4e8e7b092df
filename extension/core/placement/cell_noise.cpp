#include "placement/cell_noise.hpp"

#include <cmath>

namespace undergrowth {

uint32_t noise_bits(int column, int row) {
	uint32_t bits =
			static_cast<uint32_t>(column) * 0x9e3779b1u ^ (static_cast<uint32_t>(row) * 0x85ebca77u + 0xc2b2ae3du);
	bits = (bits ^ (bits >> 15)) * 0x2c1b3c6du;
	bits = (bits ^ (bits >> 12)) * 0x297a2d39u;
	return bits ^ (bits >> 15);
}

double smooth_noise(double x, double z) {
	const double column = std::floor(x);
	const double row = std::floor(z);
	const auto corner = [&](int i, int j) {
		const uint32_t bits = noise_bits(static_cast<int>(column) + i, static_cast<int>(row) + j);
		return static_cast<double>(bits) * (2.0 / 4294967296.0) - 1.0;
	};
	const auto smooth = [](double share) { return share * share * (3.0 - 2.0 * share); };
	const double across = smooth(x - column);
	const double along = smooth(z - row);
	const double low = corner(0, 0) + (corner(1, 0) - corner(0, 0)) * across;
	const double high = corner(0, 1) + (corner(1, 1) - corner(0, 1)) * across;
	return low + (high - low) * along;
}

} // namespace undergrowth

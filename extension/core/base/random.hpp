#pragma once

#include <cstdint>

namespace undergrowth {

/// SplitMix64 (Steele, Lea and Flood 2014): a good 64-bit mix from a counter, the same on every platform.
constexpr uint64_t mix_bits(uint64_t value) {
	value += 0x9e3779b97f4a7c15ull;
	value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ull;
	value = (value ^ (value >> 27)) * 0x94d049bb133111ebull;
	return value ^ (value >> 31);
}

/// Bits [16·part, 16·part + 16) as a number in [0, 1).
constexpr double unit16(uint64_t bits, int part) {
	return static_cast<double>((bits >> (16 * part)) & 0xffff) * (1.0 / 65536.0);
}

/// The number `index` of the stream `seed`, uniform in [-1, 1).
constexpr float signed_noise(uint64_t seed, uint64_t index) {
	const uint64_t bits = mix_bits(mix_bits(seed) ^ index) >> 40;
	return static_cast<float>(bits) * (2.0f / 16777216.0f) - 1.0f;
}

} // namespace undergrowth

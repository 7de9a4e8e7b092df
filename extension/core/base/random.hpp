#pragma once

#include <cstdint>
#include <cstring>

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

/// The highest 24 bits as a number in [-1, 1).
constexpr float signed_unit(uint64_t bits) {
	return static_cast<float>(bits >> 40) * (2.0f / 16777216.0f) - 1.0f;
}

/// The number `index` of the stream `seed`, uniform in [-1, 1).
constexpr float signed_noise(uint64_t seed, uint64_t index) {
	return signed_unit(mix_bits(mix_bits(seed) ^ index));
}

/// Mixed bits of a position seen from above.
inline uint64_t bits_of_place(uint64_t seed, float x, float z) {
	uint32_t place[2];
	std::memcpy(&place[0], &x, sizeof place[0]);
	std::memcpy(&place[1], &z, sizeof place[1]);
	return mix_bits(mix_bits(seed ^ place[0]) ^ place[1]);
}

} // namespace undergrowth

#include "motion/bend_encoding.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace undergrowth {

namespace {

constexpr float MAX_VALUE = 6e4f; // The limit of the kernels: within the range of halves.
constexpr float MIN_HEIGHT = 1e-6f;
constexpr uint32_t INFINITE_HALF = 0x7c00u;

uint32_t bits_of(float value) {
	uint32_t bits;
	std::memcpy(&bits, &value, sizeof bits);
	return bits;
}

float float_of(uint32_t bits) {
	float value;
	std::memcpy(&value, &bits, sizeof value);
	return value;
}

} // namespace

uint16_t to_half(float value) {
	const uint32_t bits = bits_of(value) & 0x7fffffffu;
	const uint32_t sign = (bits_of(value) >> 16) & 0x8000u;
	if (bits > 0x7f800000u) {
		return static_cast<uint16_t>(sign | INFINITE_HALF | 0x200u);
	}
	if (bits >= 0x477ff000u) {
		return static_cast<uint16_t>(sign | INFINITE_HALF);
	}
	if (bits < 0x38800000u) {
		// Below 2^-14 a half has no leading one: adding 1/2 rounds to its last bit, 2^-24.
		return static_cast<uint16_t>(sign | (bits_of(float_of(bits) + 0.5f) - 0x3f000000u));
	}
	return static_cast<uint16_t>(sign | ((bits - 0x38000000u + 0xfffu + ((bits >> 13) & 1u)) >> 13));
}

float from_half(uint16_t half) {
	const uint32_t sign = static_cast<uint32_t>(half & 0x8000u) << 16;
	const uint32_t size = half & 0x7fffu;
	if (size >= INFINITE_HALF) {
		return float_of(sign | 0x7f800000u | ((size & 0x3ffu) << 13));
	}
	// 2^112 corrects the exponent, which starts from 15 instead of 127. Subnormals become correct as well.
	const float value = float_of(size << 13) * 0x1p112f;
	return sign != 0u ? -value : value;
}

Bend encode_bend(const glm::vec3 &direction) {
	const float scale = 1.0f / std::max(1.0f + direction.y, MIN_HEIGHT);
	const float x = std::clamp(direction.x * scale, -MAX_VALUE, MAX_VALUE);
	const float z = std::clamp(direction.z * scale, -MAX_VALUE, MAX_VALUE);
	return pack_bend({ x, z });
}

Bend pack_bend(const glm::vec2 &s) {
	return static_cast<Bend>(to_half(s.x)) | static_cast<Bend>(to_half(s.y)) << 16;
}

glm::vec2 stereographic(Bend bend) {
	return { from_half(static_cast<uint16_t>(bend & 0xffffu)), from_half(static_cast<uint16_t>(bend >> 16)) };
}

glm::vec3 decode_bend(Bend bend) {
	return from_stereographic(stereographic(bend));
}

BendWay bend_way(const Bend *pair, float share) {
	const glm::vec2 before = stereographic(pair[0]);
	const glm::vec2 after = stereographic(pair[1]);
	return { glm::mix(before, after, share), after - before };
}

glm::vec3 from_stereographic(const glm::vec2 &s) {
	const float n = glm::dot(s, s);
	return glm::vec3(2.0f * s.x, 1.0f - n, 2.0f * s.y) / (1.0f + n);
}

} // namespace undergrowth

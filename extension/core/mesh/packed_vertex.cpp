#include "mesh/packed_vertex.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace undergrowth {

static constexpr float HALF_SQUARE = 511.0f; // Steps from the middle of the octahedral square to its edge.
static constexpr float TURN = 6.28318531f;

// Returns a value from 0 to `most` in steps.
static uint32_t steps_of(float value, float steps, uint32_t most) {
	return uint32_t(std::clamp(std::round(value * steps), 0.0f, float(most)));
}

static uint32_t half_of(float value) {
	return glm::packHalf1x16(value);
}

// Returns the half float of a value that is not negative. It has 15 bits.
static uint32_t positive_half_of(float value) {
	return half_of(std::max(value, 0.0f)) & 0x7fffu;
}

static float signed_one(float value) {
	return value >= 0.0f ? 1.0f : -1.0f;
}

// Returns the octahedral coordinates of a direction in steps, from 0 to 1022.
static glm::uvec2 square_of(const glm::vec3 &direction) {
	const float sum = std::fabs(direction.x) + std::fabs(direction.y) + std::fabs(direction.z);
	if (sum <= 0.0f) {
		return glm::uvec2(uint32_t(HALF_SQUARE));
	}
	glm::vec2 at = glm::vec2(direction) / sum;
	if (direction.z < 0.0f) {
		at = { (1.0f - std::fabs(at.y)) * signed_one(at.x), (1.0f - std::fabs(at.x)) * signed_one(at.y) };
	}
	return glm::uvec2(glm::round((at + 1.0f) * HALF_SQUARE));
}

static glm::vec3 direction_of(const glm::uvec2 &square) {
	const glm::vec2 at = glm::vec2(square) / HALF_SQUARE - 1.0f;
	glm::vec3 direction(at, 1.0f - std::fabs(at.x) - std::fabs(at.y));
	const float fold = std::max(-direction.z, 0.0f);
	direction.x -= fold * signed_one(direction.x);
	direction.y -= fold * signed_one(direction.y);
	return glm::normalize(direction);
}

// Returns the angle of the tangent about the normal that the shader reads, from an axis that follows from the normal
// (Duff et al. 2017).
static uint32_t angle_of(const glm::vec3 &tangent, const glm::vec3 &normal) {
	const float sign = signed_one(normal.z);
	const float a = -1.0f / (sign + normal.z);
	const float b = normal.x * normal.y * a;
	const glm::vec3 first(1.0f + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
	const glm::vec3 second(b, sign + normal.y * normal.y * a, -normal.y);
	const float angle = std::atan2(glm::dot(tangent, second), glm::dot(tangent, first));
	return uint32_t(int(std::round(angle / TURN * 256.0f)) & 255);
}

static float to_float(uint32_t word) {
	const uint32_t bits = word | ((~word << 1) & (1u << 30));
	float number;
	std::memcpy(&number, &bits, sizeof(number));
	return number;
}

PackedSwing pack_swing(const InnerVertex &swing) {
	const uint32_t words[PackedSwing::WORDS] = {
		half_of(swing.pivot.x) | steps_of(swing.code.pace + 2048.0f, 1.0f, 4095) << 16,
		half_of(swing.pivot.y) | steps_of(swing.code.place + 2048.0f, 1.0f, 4095) << 16,
		half_of(swing.pivot.z) | steps_of(swing.weight, 255.0f, 255) << 16,
	};
	PackedSwing packed;
	std::transform(words, words + PackedSwing::WORDS, packed.words, to_float);
	return packed;
}

PackedVertex pack_vertex(const VertexAttributes &of) {
	const glm::vec3 aside(of.custom2);
	const glm::uvec2 aside_square = square_of(aside);
	const glm::uvec2 normal = square_of(of.normal);
	const uint32_t place = steps_of(of.stem_place, 16384.0f, 16383);
	// Equal offset and place stay equal: the shader corrects the difference.
	const uint32_t offset = of.custom0.x == of.stem_place ? 2 * place : steps_of(of.custom0.x, 32768.0f, 65535);
	const uint32_t code = steps_of(std::floor(of.custom0.z), 1.0f, 1023);
	const uint32_t rank = steps_of(of.custom0.z - std::floor(of.custom0.z), 256.0f, 255);
	const uint32_t weight = steps_of(of.custom0.y, 255.0f, 255);
	const uint32_t leafiness = steps_of(of.custom0.w, 63.0f, 63);
	const uint32_t angle = angle_of(of.tangent, direction_of(normal));
	const uint32_t words[PackedVertex::WORDS] = {
		offset | place << 16,
		positive_half_of(of.height) | positive_half_of(glm::length(aside)) << 15,
		aside_square.x | aside_square.y << 10 | code << 20,
		weight | leafiness << 8 | rank << 14 | angle << 22,
		half_of(of.custom1.x) | steps_of(of.custom1.w + 2048.0f, 1.0f, 4095) << 16,
		half_of(of.custom1.y) | steps_of(of.custom2.w + 2048.0f, 1.0f, 4095) << 16,
		half_of(of.custom1.z) | steps_of(of.uv.x, 1023.0f, 1023) << 16,
		steps_of(of.uv.y, 1023.0f, 1023) | normal.x << 10 | normal.y << 20,
	};
	PackedVertex packed;
	std::transform(words, words + PackedVertex::WORDS, packed.words, to_float);
	return packed;
}

} // namespace undergrowth

#include "mesh/packed_vertex.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>

#include <cmath>
#include <cstring>
#include <initializer_list>

using namespace undergrowth;

namespace {

constexpr float HALF_STEP = 1.0f / 2048.0f; // Largest relative error of a half float.
constexpr float DIRECTION_ERROR = 0.004f; // Radians: half of a diagonal step of an octahedral square of 1022 steps.
constexpr float TANGENT_ERROR = 3.14159265f / 256.0f + DIRECTION_ERROR;

uint32_t word_of(const PackedVertex &packed, int word) {
	uint32_t bits;
	std::memcpy(&bits, &packed.words[word], sizeof(bits));
	return bits & 0x3fffffffu;
}

float half_at(uint32_t word, int first, uint32_t mask) {
	return glm::unpackHalf1x16(uint16_t((word >> first) & mask));
}

glm::vec3 direction_at(uint32_t word, int first) {
	const float x = float((word >> first) & 1023u) / 511.0f - 1.0f;
	const float y = float((word >> (first + 10)) & 1023u) / 511.0f - 1.0f;
	glm::vec3 direction(x, y, 1.0f - std::fabs(x) - std::fabs(y));
	const float fold = std::max(-direction.z, 0.0f);
	direction.x += direction.x >= 0.0f ? -fold : fold;
	direction.y += direction.y >= 0.0f ? -fold : fold;
	return glm::normalize(direction);
}

// As undergrowth_unpack() in undergrowth_packed.gdshaderinc.
VertexAttributes unpacked(const PackedVertex &packed) {
	uint32_t w[PackedVertex::WORDS];
	for (int i = 0; i < PackedVertex::WORDS; i++) {
		w[i] = word_of(packed, i);
	}
	VertexAttributes all;
	all.custom0 = { float(w[0] & 0xffffu) / 32768.0f, float(w[3] & 0xffu) / 255.0f,
		float(w[2] >> 20) + float((w[3] >> 14) & 0xffu) / 256.0f, float((w[3] >> 8) & 63u) / 63.0f };
	all.custom1 = { half_at(w[4], 0, 0xffffu), half_at(w[5], 0, 0xffffu), half_at(w[6], 0, 0xffffu),
		float(w[4] >> 16) - 2048.0f };
	all.custom2 = glm::vec4(direction_at(w[2], 0) * half_at(w[1], 15, 0x7fffu), float(w[5] >> 16) - 2048.0f);
	all.height = half_at(w[1], 0, 0x7fffu);
	all.stem_place = float(w[0] >> 16) / 16384.0f;
	all.uv = { float(w[6] >> 16) / 1023.0f, float(w[7] & 1023u) / 1023.0f };
	all.normal = direction_at(w[7], 10);
	const glm::vec3 n = all.normal;
	const float side = n.z >= 0.0f ? 1.0f : -1.0f;
	const float a = -1.0f / (side + n.z);
	const float b = n.x * n.y * a;
	const float angle = float(w[3] >> 22) * (6.28318531f / 256.0f);
	all.tangent = std::cos(angle) * glm::vec3(1.0f + side * n.x * n.x * a, side * b, -side * n.x) +
			std::sin(angle) * glm::vec3(b, side + n.y * n.y * a, -n.y);
	return all;
}

VertexAttributes attributes(uint32_t seed) {
	const auto toss = [&](float low, float high) {
		seed = seed * 1103515245u + 12345u;
		return low + (high - low) * float((seed >> 8) & 0xffffu) / 65535.0f;
	};
	VertexAttributes all;
	all.normal = glm::normalize(glm::vec3(toss(-1, 1), toss(-1, 1), toss(-1, 1)) + glm::vec3(1e-4f));
	all.tangent =
			glm::normalize(glm::cross(all.normal, glm::vec3(toss(-1, 1), toss(-1, 1), toss(-1, 1)) + glm::vec3(1e-4f)));
	all.uv = { toss(0, 1), toss(0, 1) };
	all.custom0 = { toss(0, 1.5f), toss(0, 1), std::floor(toss(0, 200)) + std::floor(toss(0, 255)) / 256.0f,
		toss(0, 1) };
	all.custom1 = { toss(-3, 3), toss(0, 3), toss(-3, 3), std::round(toss(-2048, 2047)) };
	all.custom2 = { toss(-0.1f, 0.1f), toss(-0.1f, 0.1f), toss(-0.1f, 0.1f), std::round(toss(-2048, 2047)) };
	all.height = toss(0.01f, 4.0f);
	all.stem_place = toss(0, 0.99f);
	return all;
}

float angle_between(const glm::vec3 &one, const glm::vec3 &other) {
	return std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
}

} // namespace

TEST_CASE("a packed vertex keeps its attributes within their steps") {
	for (uint32_t seed = 1; seed <= 2000; seed++) {
		const VertexAttributes all = attributes(seed);
		const VertexAttributes read = unpacked(pack_vertex(all));
		CAPTURE(seed);
		REQUIRE(angle_between(read.normal, all.normal) < DIRECTION_ERROR);
		REQUIRE(angle_between(read.tangent, all.tangent) < TANGENT_ERROR);
		REQUIRE(std::fabs(read.uv.x - all.uv.x) < 0.51f / 1023.0f);
		REQUIRE(std::fabs(read.uv.y - all.uv.y) < 0.51f / 1023.0f);
		REQUIRE(std::fabs(read.custom0.x - all.custom0.x) < 0.51f / 32768.0f);
		REQUIRE(std::fabs(read.custom0.y - all.custom0.y) < 0.51f / 255.0f);
		REQUIRE(read.custom0.z == all.custom0.z);
		REQUIRE(std::fabs(read.custom0.w - all.custom0.w) < 0.51f / 63.0f);
		for (int i = 0; i < 3; i++) {
			REQUIRE(std::fabs(read.custom1[i] - all.custom1[i]) < HALF_STEP * std::fabs(all.custom1[i]) + 1e-6f);
		}
		REQUIRE(read.custom1.w == all.custom1.w);
		REQUIRE(read.custom2.w == all.custom2.w);
		const float length = glm::length(glm::vec3(all.custom2));
		REQUIRE(glm::length(glm::vec3(read.custom2 - all.custom2)) < (HALF_STEP + DIRECTION_ERROR) * length + 1e-6f);
		REQUIRE(std::fabs(read.height - all.height) < HALF_STEP * all.height);
		REQUIRE(std::fabs(read.stem_place - all.stem_place) < 0.51f / 16384.0f);
	}
}

TEST_CASE("a packed vertex keeps zeros, ends of ranges and axes exactly") {
	VertexAttributes all;
	all.custom0 = { 0.0f, 0.0f, 0.0f, 0.0f };
	all.uv = { 0.0f, 1.0f };
	const VertexAttributes low = unpacked(pack_vertex(all));
	CHECK(low.custom0 == all.custom0);
	CHECK(glm::vec3(low.custom1) == glm::vec3(0.0f));
	CHECK(glm::vec3(low.custom2) == glm::vec3(0.0f));
	CHECK(low.uv == all.uv);
	CHECK(low.normal == glm::vec3(0.0f, 1.0f, 0.0f));
	all.custom0 = { 1.0f, 1.0f, 4.0f + 255.0f / 256.0f, 1.0f };
	for (const glm::vec3 &axis : { glm::vec3(1, 0, 0), glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(0, -1, 0) }) {
		all.normal = axis;
		const VertexAttributes high = unpacked(pack_vertex(all));
		CHECK(high.custom0 == all.custom0);
		CHECK(high.normal == axis);
	}
}

TEST_CASE("an offset that is equal to the stem place stays equal to it") {
	for (uint32_t seed = 1; seed <= 500; seed++) {
		VertexAttributes all = attributes(seed);
		all.custom0.x = all.stem_place;
		const VertexAttributes read = unpacked(pack_vertex(all));
		REQUIRE(read.custom0.x == read.stem_place);
	}
}

TEST_CASE("words of a packed vertex are normal floats") {
	for (uint32_t seed = 1; seed <= 2000; seed++) {
		for (const float word : pack_vertex(attributes(seed)).words) {
			REQUIRE(std::isnormal(word));
		}
	}
}

TEST_CASE("a packed inner swing keeps its codes, and its pivot and weight within their steps") {
	for (uint32_t seed = 1; seed <= 500; seed++) {
		const VertexAttributes from = attributes(seed);
		InnerVertex swing;
		swing.pivot = glm::vec3(from.custom1);
		swing.weight = from.custom0.y;
		swing.code = { from.custom1.w, from.custom2.w };
		uint32_t words[PackedSwing::WORDS];
		const PackedSwing packed = pack_swing(swing);
		std::memcpy(words, packed.words, sizeof(words));
		for (int i = 0; i < PackedSwing::WORDS; i++) { // As undergrowth_unpack_swing().
			REQUIRE(std::isnormal(packed.words[i]));
			words[i] &= 0x3fffffffu;
			const float place = half_at(words[i], 0, 0xffffu);
			REQUIRE(std::fabs(place - swing.pivot[i]) < HALF_STEP * std::fabs(swing.pivot[i]) + 1e-6f);
		}
		REQUIRE(float(words[0] >> 16) - 2048.0f == swing.code.pace);
		REQUIRE(float(words[1] >> 16) - 2048.0f == swing.code.place);
		REQUIRE(std::fabs(float(words[2] >> 16) / 255.0f - swing.weight) < 0.51f / 255.0f);
	}
	uint32_t none;
	const PackedSwing empty = pack_swing(InnerVertex());
	std::memcpy(&none, &empty.words[2], sizeof(none));
	none = (none & 0x3fffffffu) >> 16;
	CHECK(none == 0u);
}

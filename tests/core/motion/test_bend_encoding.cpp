#include "base/random.hpp"
#include "motion/bend_encoding.hpp"
#include "motion/kernel_tables.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

using namespace undergrowth;

namespace {

constexpr float BEND_TOLERANCE = 1.1e-3f; // rad; half a code step of s near 1 is 2^-12, a step of s is twice one of d.
constexpr float UNIT_TOLERANCE = 1e-6f;

glm::vec3 chance_direction(int index) {
	const auto noise = [index](uint64_t which) { return signed_noise(which, static_cast<uint64_t>(index)); };
	return glm::normalize(glm::vec3(noise(1), 0.02f + std::fabs(noise(2)), noise(3)));
}

} // namespace

TEST_CASE("every half float survives conversion to a float and back") {
	bool same = true;
	for (uint32_t half = 0; half <= 0xffffu; half++) {
		const float value = from_half(static_cast<uint16_t>(half));
		same = same && (std::isnan(value) ? (half & 0x7fffu) > 0x7c00u : to_half(value) == half);
	}
	CHECK(same);
}

TEST_CASE("a float becomes the nearest half, ties to the even one") {
	for (uint32_t half = 0; half < 0x7bffu; half++) {
		const float low = from_half(static_cast<uint16_t>(half));
		const float high = from_half(static_cast<uint16_t>(half + 1));
		const float middle = 0.5f * (low + high); // Exact: a float has 13 more bits.
		REQUIRE(to_half(middle) == (half % 2 == 0 ? half : half + 1));
		REQUIRE(to_half(std::nextafter(middle, low)) == half);
		REQUIRE(to_half(std::nextafter(middle, high)) == half + 1);
		REQUIRE(to_half(-middle) == (0x8000u | to_half(middle)));
	}
}

TEST_CASE("numbers out of the range of a half become infinite or NaN") {
	CHECK(to_half(1.0f) == 0x3c00u);
	CHECK(to_half(65519.0f) == 0x7bffu);
	CHECK(to_half(65520.0f) == 0x7c00u);
	CHECK(to_half(-1e30f) == 0xfc00u);
	CHECK(std::isnan(from_half(to_half(std::numeric_limits<float>::quiet_NaN()))));
}

TEST_CASE("a bend decodes to its direction") {
	for (int i = 0; i < 2000; i++) {
		const glm::vec3 direction = chance_direction(i);
		const glm::vec3 decoded = decode_bend(encode_bend(direction));
		CHECK(glm::distance(decoded, direction) < BEND_TOLERANCE);
		CHECK(std::fabs(glm::length(decoded) - 1.0f) < UNIT_TOLERANCE);
	}
	CHECK(encode_bend({ 0.0f, 1.0f, 0.0f }) == 0u);
	CHECK(std::isfinite(decode_bend(encode_bend({ 1e-4f, -1.0f, 0.0f })).x));
}

TEST_CASE("a page's kernels give the same code as a single direction") {
	for (const SimdLevel level : { SimdLevel::baseline, SimdLevel::avx2 }) {
		constexpr int COUNT = 515; // More than one block, and a remainder.
		std::vector<float> x, y, z, flat_x, flat_z;
		std::vector<Bend> expected;
		for (int i = 0; i < COUNT; i++) {
			const glm::vec3 direction = chance_direction(i);
			x.push_back(direction.x);
			y.push_back(direction.y);
			z.push_back(direction.z);
			flat_x.push_back(direction.x / direction.y);
			flat_z.push_back(direction.z / direction.y);
			expected.push_back(encode_bend(direction));
		}
		std::vector<Bend> pairs(2 * COUNT, 7u), flat_pairs(2 * COUNT, 9u);
		kernels(level).encode_elasticity(x.data(), y.data(), z.data(), COUNT, pairs.data());
		kernels(level).encode_spring(flat_x.data(), flat_z.data(), COUNT, flat_pairs.data());
		for (size_t i = 0; i < COUNT; i++) {
			REQUIRE(pairs[2 * i] == 7u);
			REQUIRE(pairs[2 * i + 1] == expected[i]);
			REQUIRE(flat_pairs[2 * i] == 9u);
			REQUIRE(glm::distance(decode_bend(flat_pairs[2 * i + 1]), decode_bend(expected[i])) < BEND_TOLERANCE);
		}
	}
}

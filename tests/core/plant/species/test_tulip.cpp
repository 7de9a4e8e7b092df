#include "plant/species/tulip.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace undergrowth;

TEST_CASE("the tulip's width is the thesis's, to the digit") {
	const Tulip tulip;
	for (const float offset : { 0.0f, 0.3f, 0.7499f }) {
		CHECK(tulip.width(offset) == 0.1f);
	}
	CHECK(tulip.width(0.75f) == 0.5f);
	for (const float offset : { 0.76f, 0.8f, 0.9f, 1.0f }) {
		const double exact = 0.5 + std::sin((static_cast<double>(offset) - 0.75) / 0.3 * 3.14159265358979323846) / 3.0;
		CHECK(std::abs(tulip.width(offset) - exact) < 3e-8);
	}
	// sin(150°) = 1/2 at the tip.
	CHECK(tulip.width(1.0f) == doctest::Approx(2.0 / 3.0).epsilon(1e-7));
}

TEST_CASE("the tulip is green below the flower and red above") {
	const Tulip tulip;
	CHECK(tulip.color(0.0f) == glm::vec4(0.2f, 0.85f, 0.2f, 1.0f));
	CHECK(tulip.color(0.7499f) == glm::vec4(0.2f, 0.85f, 0.2f, 1.0f));
	CHECK(tulip.color(0.75f) == glm::vec4(0.8f, 0.1f, 0.1f, 1.0f));
	CHECK(tulip.color(1.0f) == glm::vec4(0.8f, 0.1f, 0.1f, 1.0f));
}

TEST_CASE("tulips grow on a circle of 0.3 m") {
	const std::vector<glm::vec2> ring = Tulip().base_shape(16);
	REQUIRE(ring.size() == 16);
	CHECK(ring[0].x == -0.3f);
	CHECK(ring[4].y == 0.3f);
}

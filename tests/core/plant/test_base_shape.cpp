#include "../mesh/mesh_fixture.hpp"
#include "plant/base_shape.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <cmath>

using namespace undergrowth;

namespace {

constexpr double PI_DIGITS = 3.14159265358979323846;

RingFault fault_of(const std::vector<glm::vec2> &ring) {
	std::vector<glm::vec3> points;
	for (const glm::vec2 p : ring) {
		points.push_back({ p.x, 0.0f, p.y });
	}
	return find_ring_fault(points.data(), static_cast<int>(points.size()));
}

} // namespace

TEST_CASE("the circle is the thesis's, to the digit") {
	for (const int lod : { 1, 4, 5, 16, 31 }) {
		const std::vector<glm::vec2> ring = circle_ring(lod);
		const int n = std::max(4, lod);
		REQUIRE(static_cast<int>(ring.size()) == n);
		for (int i = 0; i < n; i++) {
			const double angle = 2.0 * PI_DIGITS * i / n;
			CHECK(std::abs(ring[i].x + std::cos(angle) * 0.3) < 2e-8);
			CHECK(std::abs(ring[i].y - std::sin(angle) * 0.3) < 2e-8);
		}
	}
}

TEST_CASE("a parallelogram has the given width, depth and skew and lies around the root") {
	const std::vector<glm::vec2> ring = parallelogram_ring(0.04f, 0.01f, 0.02f);
	REQUIRE(ring.size() == 4);
	CHECK(ring[1].x - ring[0].x == doctest::Approx(0.04));
	CHECK(ring[2].x - ring[3].x == doctest::Approx(0.04));
	CHECK(ring[0].y - ring[3].y == doctest::Approx(0.01));
	CHECK(ring[3].x - ring[0].x == doctest::Approx(0.02));
	const glm::vec2 middle = ring[0] + ring[1] + ring[2] + ring[3];
	CHECK(glm::length(middle) < 1e-7f);
}

TEST_CASE("a lobed ring shows all its lobes at any level of detail") {
	for (const int lod : { 1, 8, 20, 24, 50 }) {
		const std::vector<glm::vec2> ring = lobed_ring(lod, 0.05, 5, 0.25);
		CHECK(static_cast<int>(ring.size()) >= std::max(lod, 20));
		int crests = 0;
		const size_t n = ring.size();
		for (size_t i = 0; i < n; i++) {
			const float here = glm::length(ring[i]);
			crests += here > glm::length(ring[(i + n - 1) % n]) && here > glm::length(ring[(i + 1) % n]);
			CHECK(here <= 0.05f * 1.25f + 1e-6f);
			CHECK(here >= 0.05f * 0.75f - 1e-6f);
		}
		CHECK(crests == 5);
	}
}

TEST_CASE("all base shapes are sound rings, also at levels out of range") {
	for (const int lod : { -3, 0, 1, 4, 24, MAX_LOD, 100000 }) {
		CHECK(fault_of(circle_ring(lod)) == RingFault::none);
		CHECK(fault_of(lobed_ring(lod, 0.1, 7, 0.9)) == RingFault::none);
	}
	CHECK(fault_of(parallelogram_ring(0.03f, 0.004f, 0.05f)) == RingFault::none);
	CHECK(fault_of(star_ring()) == RingFault::none);
}

#include "mesh/ear_clipping.hpp"
#include "mesh_fixture.hpp"
#include "plant/base_shape.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <utility>

using namespace undergrowth;

namespace {

using Ring = std::vector<glm::vec2>;

// A comb of narrow teeth: the centre of the ring is far from most of its area.
Ring comb_ring(int teeth) {
	Ring ring = { { 0.0f, 1.0f }, { static_cast<float>(teeth), 1.0f } };
	for (int i = teeth; i > 0; i--) {
		ring.push_back({ static_cast<float>(i) - 0.5f, -1.0f });
		ring.push_back({ static_cast<float>(i) - 1.0f, 0.9f });
	}
	ring.back() = { 0.0f, 0.5f };
	return ring;
}

// A square with extra points on its sides.
Ring studded_square() {
	return { { -1.0f, 1.0f }, { 0.0f, 1.0f }, { 1.0f, 1.0f }, { 1.0f, 0.5f }, { 1.0f, 0.0f }, { 1.0f, -1.0f },
		{ 0.0f, -1.0f }, { -1.0f, -1.0f } };
}

void check_filled(const Ring &ring) {
	const std::vector<int32_t> triangles = clip_ears(ring);
	REQUIRE(triangles.size() == 3 * (ring.size() - 2));
	double area = 0.0;
	std::map<std::pair<int, int>, int> edges;
	for (size_t i = 0; i < triangles.size(); i += 3) {
		const Ring triangle = { ring[triangles[i]], ring[triangles[i + 1]], ring[triangles[i + 2]] };
		const double part = ring_area(triangle);
		CHECK(part >= 0.0);
		area += part;
		for (int k = 0; k < 3; k++) {
			edges[{ triangles[i + k], triangles[i + (k + 1) % 3] }]++;
		}
	}
	// Triangles of one sign with the ring's area as sum neither overlap nor leave it.
	CHECK(area == doctest::Approx(ring_area(ring)).epsilon(1e-6));
	const int n = static_cast<int>(ring.size());
	for (const auto &[edge, uses] : edges) {
		const bool rim = edge.second == (edge.first + 1) % n;
		CHECK(uses == 1);
		CHECK((rim || edges.count({ edge.second, edge.first }) == 1));
	}
	for (int i = 0; i < n; i++) {
		CHECK(edges.count({ i, (i + 1) % n }) == 1);
	}
}

} // namespace

TEST_CASE("ear clipping fills convex and concave rings, each point and each edge of them") {
	check_filled({ { -1.0f, 0.0f }, { 0.0f, 1.0f }, { 1.0f, 0.0f } });
	check_filled(circle_ring(40));
	check_filled(parallelogram_ring(0.03f, 0.005f, 0.02f));
	check_filled(star_ring());
	check_filled(lobed_ring(40, 0.05, 5, 0.6));
	check_filled(comb_ring(12));
	check_filled(studded_square());
}

TEST_CASE("ear clipping fills the largest ring") {
	check_filled(circle_ring(MAX_RING_POINTS));
}

TEST_CASE("ear clipping of points on a line ends and uses only the ring's points") {
	const std::vector<int32_t> triangles =
			clip_ears({ { 0.0f, 0.0f }, { 1.0f, 0.0f }, { 2.0f, 0.0f }, { 3.0f, 0.0f } });
	CHECK(triangles.size() == 6);
	CHECK(std::all_of(triangles.begin(), triangles.end(), [](int32_t i) { return i >= 0 && i < 4; }));
}

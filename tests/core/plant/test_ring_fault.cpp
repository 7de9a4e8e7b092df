#include "plant/base_shape.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <set>
#include <string>

using namespace undergrowth;

namespace {

using Points = std::vector<glm::vec3>;

RingFault fault_of(const Points &points) {
	return find_ring_fault(points.data(), static_cast<int>(points.size()));
}

/// Points on the ground.
Points flat(std::initializer_list<glm::vec2> ring) {
	Points points;
	for (const glm::vec2 p : ring) {
		points.push_back({ p.x, 0.0f, p.y });
	}
	return points;
}

const Points SQUARE = flat({ { -1.0f, 1.0f }, { 1.0f, 1.0f }, { 1.0f, -1.0f }, { -1.0f, -1.0f } });

Points square_with(glm::vec3 first) {
	Points points = SQUARE;
	points[0] = first;
	return points;
}

} // namespace

TEST_CASE("sound rings have no fault") {
	CHECK(fault_of(SQUARE) == RingFault::none);
	// Concave, with a point in the middle of a side, away from the root, and very small.
	CHECK(fault_of(flat({ { 0.0f, 2.0f }, { 1.0f, 2.0f }, { 2.0f, 2.0f }, { 1.0f, 1.5f }, { 2.0f, 0.0f },
				  { 0.0f, 0.0f } })) == RingFault::none);
	CHECK(fault_of(flat({ { -1e-6f, 0.0f }, { 0.0f, 1e-6f }, { 1e-6f, 0.0f } })) == RingFault::none);
}

TEST_CASE("too few and too many points") {
	CHECK(fault_of({}) == RingFault::too_few_points);
	CHECK(fault_of(flat({ { 0.0f, 0.0f } })) == RingFault::too_few_points);
	CHECK(fault_of(flat({ { 0.0f, 0.0f }, { 1.0f, 0.0f } })) == RingFault::too_few_points);
	CHECK(fault_of(Points(MAX_RING_POINTS + 1)) == RingFault::too_many_points);
}

TEST_CASE("points that are not finite") {
	const float nan = std::numeric_limits<float>::quiet_NaN();
	const float infinity = std::numeric_limits<float>::infinity();
	CHECK(fault_of(square_with({ nan, 0.0f, 1.0f })) == RingFault::not_finite);
	CHECK(fault_of(square_with({ -1.0f, nan, 1.0f })) == RingFault::not_finite);
	CHECK(fault_of(square_with({ -1.0f, 0.0f, infinity })) == RingFault::not_finite);
}

TEST_CASE("points off the ground, but for rounding") {
	CHECK(fault_of(square_with({ -1.0f, 0.1f, 1.0f })) == RingFault::not_planar);
	CHECK(fault_of(square_with({ -1.0f, -0.001f, 1.0f })) == RingFault::not_planar);
	CHECK(fault_of(square_with({ -1.0f, 1e-5f, 1.0f })) == RingFault::none);
	Points raised = SQUARE;
	for (glm::vec3 &p : raised) {
		p.y = 0.5f;
	}
	CHECK(fault_of(raised) == RingFault::not_planar);
}

TEST_CASE("rings without area") {
	CHECK(fault_of(Points(5)) == RingFault::no_area);
	CHECK(fault_of(flat({ { 0.0f, 0.0f }, { 1.0f, 1.0f }, { 2.0f, 2.0f }, { 3.0f, 3.0f } })) == RingFault::no_area);
}

TEST_CASE("a ring that runs clockwise as seen from above") {
	CHECK(fault_of({ SQUARE.rbegin(), SQUARE.rend() }) == RingFault::clockwise);
}

TEST_CASE("edges that cross") {
	CHECK(fault_of(flat({ { -1.0f, 1.0f }, { 1.0f, 1.0f }, { -0.5f, -1.0f }, { 0.5f, -2.0f }, { 0.5f, -1.0f } })) ==
			RingFault::self_crossing);
	// A pentagram winds twice: its area has the right sign.
	CHECK(fault_of(flat({ { -1.0f, 0.0f }, { 0.81f, 0.59f }, { -0.31f, -0.95f }, { -0.31f, 0.95f },
				  { 0.81f, -0.59f } })) == RingFault::self_crossing);
}

TEST_CASE("edges that touch") {
	// A point on another edge.
	CHECK(fault_of(flat({ { -1.0f, 1.0f }, { 1.0f, 1.0f }, { 1.0f, -1.0f }, { 0.0f, 1.0f }, { -1.0f, -1.0f } })) ==
			RingFault::self_crossing);
	// A spike that runs out and back on itself.
	CHECK(fault_of(flat({ { -1.0f, 1.0f }, { 1.0f, 1.0f }, { 2.0f, 1.0f }, { 1.0f, 1.0f }, { 1.0f, -1.0f },
				  { -1.0f, -1.0f } })) == RingFault::self_crossing);
	CHECK(fault_of(flat({ { -1.0f, 1.0f }, { 3.0f, 1.0f }, { 1.0f, 1.0f }, { 1.0f, -1.0f }, { -1.0f, -1.0f } })) ==
			RingFault::self_crossing);
}

TEST_CASE("duplicate points") {
	Points repeated = SQUARE;
	repeated.insert(repeated.begin() + 1, SQUARE[1]);
	CHECK(fault_of(repeated) == RingFault::self_crossing);
	Points closed = SQUARE;
	closed.push_back(SQUARE[0]);
	CHECK(fault_of(closed) == RingFault::self_crossing);
	// Two squares that meet in one point.
	CHECK(fault_of(flat({ { -1.0f, 1.0f }, { 0.0f, 1.0f }, { 0.0f, 0.0f }, { 1.0f, 0.0f }, { 1.0f, -1.0f },
				  { 0.0f, -1.0f }, { 0.0f, 0.0f }, { -1.0f, 0.0f } })) == RingFault::self_crossing);
}

TEST_CASE("each fault has its own sentence") {
	std::set<std::string> sentences;
	for (int fault = 0; fault <= static_cast<int>(RingFault::self_crossing); fault++) {
		sentences.insert(describe(static_cast<RingFault>(fault)));
	}
	CHECK(sentences.size() == 8);
	CHECK(sentences.count("") == 0);
}

#include "placement/area.hpp"
#include "placement/area_row.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>

using namespace undergrowth;

namespace {

/// A U that is open towards +z, with arms one metre wide.
const Polygon U_SHAPE = { { 0, 0 }, { 5, 0 }, { 5, 5 }, { 4, 5 }, { 4, 1 }, { 1, 1 }, { 1, 5 }, { 0, 5 } };

} // namespace

TEST_CASE("a point is inside if the polygon winds around it, for any shape and direction") {
	const Polygon reversed(U_SHAPE.rbegin(), U_SHAPE.rend());
	for (const Polygon &polygon : { U_SHAPE, reversed }) {
		CHECK(is_inside(polygon, { 0.5f, 4.0f }));
		CHECK(is_inside(polygon, { 4.5f, 4.0f }));
		CHECK(is_inside(polygon, { 2.5f, 0.5f }));
		CHECK_FALSE(is_inside(polygon, { 2.5f, 3.0f }));
		CHECK_FALSE(is_inside(polygon, { -0.5f, 3.0f }));
		CHECK_FALSE(is_inside(polygon, { 5.5f, 3.0f }));
		CHECK_FALSE(is_inside(polygon, { 2.5f, 6.0f }));
	}
}

TEST_CASE("a point on the seam of two areas is in exactly one of them") {
	const Polygon square = rectangle({ 2, 2 });
	CHECK(is_inside(square, { -1, 0 }));
	CHECK(is_inside(square, { 0, -1 }));
	CHECK(is_inside(square, { -1, -1 }));
	CHECK_FALSE(is_inside(square, { 1, 0 }));
	CHECK_FALSE(is_inside(square, { 0, 1 }));
	CHECK_FALSE(is_inside(square, { 1, 1 }));

	const Polygon left = { { -1, -1 }, { 0.3f, -1 }, { -0.2f, 1 }, { -1, 1 } };
	const Polygon right = { { -0.2f, 1 }, { 0.3f, -1 }, { 1, -1 }, { 1, 1 } };
	for (int i = -1000; i < 1000; i++) {
		const float z = static_cast<float>(i) * 0.001f;
		const glm::vec2 seam = { 0.05f - 0.25f * z, z };
		CHECK(is_inside(left, seam) != is_inside(right, seam));
	}
}

TEST_CASE("a region that a polygon winds around twice is outside") {
	const Polygon star = { { 0, -1 }, { 0.59f, 0.81f }, { -0.95f, -0.31f }, { 0.95f, -0.31f }, { -0.59f, 0.81f } };
	CHECK_FALSE(is_inside(star, { 0.01f, 0.01f }));
	CHECK(is_inside(star, { 0.01f, -0.7f }));
}

TEST_CASE("areas, boxes and perimeters match geometry") {
	CHECK(signed_area(rectangle({ 3, 2 }, { 100, -50 })) == doctest::Approx(6.0));
	CHECK(perimeter(rectangle({ 3, 2 })) == doctest::Approx(10.0));
	CHECK(signed_area(U_SHAPE) == doctest::Approx(13.0));
	CHECK(signed_area(Polygon(U_SHAPE.rbegin(), U_SHAPE.rend())) == doctest::Approx(-13.0));
	const AreaBox box = bounding_box(U_SHAPE);
	CHECK(box.low == glm::vec2(0, 0));
	CHECK(box.high == glm::vec2(5, 5));
	CHECK(signed_area({}) == 0.0);
	CHECK(perimeter({}) == 0.0);
	CHECK(bounding_box({}).high == glm::vec2(0, 0));
	CHECK_FALSE(is_inside({}, { 0, 0 }));
	CHECK(rectangle({ -3, 2 }) == rectangle({ 3, -2 }));
}

TEST_CASE("each fault of an area is detected and has a sentence") {
	const float nan = std::numeric_limits<float>::quiet_NaN();
	const float infinity = std::numeric_limits<float>::infinity();
	CHECK(find_area_fault(U_SHAPE) == AreaFault::none);
	CHECK(find_area_fault({}) == AreaFault::too_few_points);
	CHECK(find_area_fault({ { 0, 0 }, { 1, 0 } }) == AreaFault::too_few_points);
	CHECK(find_area_fault({ { 0, 0 }, { 1, nan }, { 1, 1 } }) == AreaFault::not_finite);
	CHECK(find_area_fault({ { 0, 0 }, { infinity, 0 }, { 1, 1 } }) == AreaFault::not_finite);
	CHECK(find_area_fault({ { 0, 0 }, { 2.0e5f, 0 }, { 1, 1 } }) == AreaFault::too_far);
	CHECK(find_area_fault(rectangle({ 0, 3 })) == AreaFault::no_area);
	CHECK(find_area_fault(rectangle({ 0, 0 })) == AreaFault::no_area);
	CHECK(find_area_fault({ { 0, 0 }, { 1, 1 }, { 3, 3 } }) == AreaFault::no_area);
	CHECK(find_area_fault(rectangle({ 0.1f, 1000 })) == AreaFault::none);
	CHECK(find_area_fault(rectangle({ 1.0e-3f, 1.0e-3f }, { 1, 1 })) == AreaFault::none);
	// On a line, to a millionth of its length.
	for (const float length : { 1.0f, 1000.0f }) {
		CHECK(find_area_fault({ { 0, 0 }, { length, 0 }, { 0, 1.2e-6f * length } }) == AreaFault::none);
		CHECK(find_area_fault({ { 0, 0 }, { length, 0 }, { 0, 0.8e-6f * length } }) == AreaFault::no_area);
	}
	for (int fault = 0; fault <= static_cast<int>(AreaFault::no_area); fault++) {
		CHECK(std::string(describe(static_cast<AreaFault>(fault))).back() == '.');
	}
}

TEST_CASE("a row of an area gives the same results for its points as the whole area") {
	const Polygon hole = { { 0.2f, 0.2f }, { 4.7f, 0.7f }, { 2.0f, 4.0f } };
	for (int j = -4; j < 44; j++) {
		const double low = j * 0.125;
		AreaRow row(U_SHAPE, { hole, {} }, low, low + 0.125);
		join(row.spans);
		for (int i = -100; i < 700; i++) {
			const glm::vec2 point = { static_cast<float>(i) * 0.01f, static_cast<float>(low + 0.0625) };
			const bool inside = is_inside(U_SHAPE, point);
			CHECK(row.holds(point) == (inside && !is_inside(hole, point)));
			bool is_spanned = false;
			for (const AreaSpan &span : row.spans) {
				is_spanned = is_spanned || (point.x >= span.low && point.x <= span.high);
			}
			CHECK((is_spanned || !inside));
		}
		CHECK(row.spans.size() <= 2);
	}
}

TEST_CASE("the difference of two polygons is in the box around the changed part") {
	const Polygon one = { { 0, 0 }, { 10, 0 }, { 10, 10 }, { 0, 10 } };
	Polygon other = one;
	other[2] = { 12, 13 };
	const AreaBox box = changed_box(one, other);
	CHECK(box.low == glm::vec2(0, 0));
	CHECK(box.high == glm::vec2(12, 13));
	other = { { 0, 10 }, { 0, 0 }, { 10, 0 }, { 10, 4 }, { 9, 5 }, { 10, 6 }, { 10, 10 } };
	const AreaBox notch = changed_box(one, other);
	CHECK(notch.low == glm::vec2(9, 0)); // Of the side that has the notch.
	CHECK(notch.high == glm::vec2(10, 10));
	const Polygon turned = { one[2], one[1], one[0], one[3] };
	const AreaBox none = changed_box(one, turned);
	CHECK(none.low.x > none.high.x);
	CHECK(changed_box(one, {}).high == glm::vec2(10, 10));
	CHECK(changed_box({}, {}).low.x > changed_box({}, {}).high.x);
}

#include "placement/placed_area.hpp"

#include <doctest/doctest.h>

#include <memory>

using namespace undergrowth;

namespace {

constexpr float MARGIN = 0.01f; // m.

PlacementRequest request_of(const Polygon &area, const std::vector<Polygon> &exclusions) {
	PlacementRequest request;
	request.area = area;
	request.exclusions = exclusions;
	return request;
}

void check_box(const std::optional<AreaBox> &box, const glm::vec2 &low, const glm::vec2 &high) {
	REQUIRE(box.has_value());
	CHECK(box->low.x == doctest::Approx(low.x - MARGIN));
	CHECK(box->low.y == doctest::Approx(low.y - MARGIN));
	CHECK(box->high.x == doctest::Approx(high.x + MARGIN));
	CHECK(box->high.y == doctest::Approx(high.y + MARGIN));
}

} // namespace

TEST_CASE("shapes can be tracked after a placement while their number is unchanged") {
	PlacedArea placed;
	const PlacementRequest request = request_of(rectangle({ 20, 20 }), { rectangle({ 2, 2 }) });
	CHECK_FALSE(placed.can_follow(request));
	placed.store_shapes(request);
	CHECK(placed.can_follow(request));
	CHECK_FALSE(placed.can_follow(request_of(rectangle({ 20, 20 }), {})));
}

TEST_CASE("a moved path changes its old and its new position, once") {
	PlacedArea placed;
	placed.store_shapes(request_of(rectangle({ 20, 20 }), { rectangle({ 2, 2 }) }));
	const PlacementRequest moved = request_of(rectangle({ 20, 20 }), { rectangle({ 2, 2 }, { 5, 3 }) });
	check_box(placed.follow(moved), { -1, -1 }, { 6, 4 });
	CHECK_FALSE(placed.follow(moved).has_value());
}

TEST_CASE("a wider outline changes its box, except with a map") {
	PlacedArea placed;
	placed.store_shapes(request_of(rectangle({ 20, 20 }), {}));
	PlacementRequest wider = request_of(rectangle({ 24, 20 }), {});
	check_box(placed.follow(wider), { -12, -10 }, { 12, 10 });
	wider.area = rectangle({ 30, 20 });
	wider.map = std::make_shared<DensityMap>();
	CHECK_FALSE(placed.follow(wider).has_value());
}

TEST_CASE("a moved path also changes the plants within the edge falloff") {
	PlacedArea placed;
	placed.store_shapes(request_of(rectangle({ 20, 20 }), { rectangle({ 2, 2 }) }));
	PlacementRequest moved = request_of(rectangle({ 20, 20 }), { rectangle({ 2, 2 }, { 5, 3 }) });
	moved.edge_falloff = 0.75f;
	check_box(placed.follow(moved), { -1.75f, -1.75f }, { 6.75f, 4.75f });
}

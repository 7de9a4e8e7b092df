#include "stand/standing_area.hpp"

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
	StandingArea standing;
	const PlacementRequest request = request_of(rectangle({ 20, 20 }), { rectangle({ 2, 2 }) });
	CHECK_FALSE(standing.can_follow(request));
	standing.stand_by(request);
	CHECK(standing.can_follow(request));
	CHECK_FALSE(standing.can_follow(request_of(rectangle({ 20, 20 }), {})));
}

TEST_CASE("a moved path changes its old and its new position, once") {
	StandingArea standing;
	standing.stand_by(request_of(rectangle({ 20, 20 }), { rectangle({ 2, 2 }) }));
	const PlacementRequest moved = request_of(rectangle({ 20, 20 }), { rectangle({ 2, 2 }, { 5, 3 }) });
	check_box(standing.follow(moved), { -1, -1 }, { 6, 4 });
	CHECK_FALSE(standing.follow(moved).has_value());
}

TEST_CASE("a wider outline changes its box, except with a map") {
	StandingArea standing;
	standing.stand_by(request_of(rectangle({ 20, 20 }), {}));
	PlacementRequest wider = request_of(rectangle({ 24, 20 }), {});
	check_box(standing.follow(wider), { -12, -10 }, { 12, 10 });
	wider.area = rectangle({ 30, 20 });
	wider.map = std::make_shared<DensityMap>();
	CHECK_FALSE(standing.follow(wider).has_value());
}

#include "field/follow_delays.hpp"

#include <doctest/doctest.h>

using namespace undergrowth;
using doctest::Approx;

namespace {

constexpr float STEP = 1.0f / 50.0f;
constexpr int STEPS = 50; // Of FollowDelays::GOING_OVER.

FollowDelays going_to(const DelayPlane &plane) {
	FollowDelays delays(STEP);
	delays.set({});
	delays.want(plane);
	delays.step();
	return delays;
}

} // namespace

TEST_CASE("delays change to new ones within a second, from the step that requests them") {
	FollowDelays delays = going_to({ 1.0f, 0.0f, 3.0f });
	CHECK(delays.after() == DelayPlane{ 1.0f, 0.0f, 3.0f });
	CHECK(delays.share(0.0f) == 0.0f);
	CHECK(delays.share(0.5f) > 0.0f);
	for (int i = 0; i < STEPS / 2; i++) {
		delays.step();
	}
	CHECK(delays.share(0.0f) == Approx(0.5));
	for (int i = STEPS / 2; i < STEPS; i++) {
		CHECK(delays.share(0.0f) < 1.0f);
		delays.step();
	}
	CHECK(delays.share(0.0f) == 1.0f);
}

TEST_CASE("changes during a change of delays wait for its end") {
	const DelayPlane first = { 1.0f, 0.0f, 3.0f };
	const DelayPlane second = { 0.0f, 2.0f, 1.0f };
	FollowDelays delays = going_to(first);
	delays.want(second);
	for (int i = 1; i < STEPS; i++) {
		delays.step();
		CHECK(delays.after() == first);
	}
	delays.step();
	CHECK(delays.before() == first);
	CHECK(delays.after() == second);
	CHECK(delays.share(0.0f) == 0.0f);
}

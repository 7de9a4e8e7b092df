#include "motion/step_time.hpp"

#include <doctest/doctest.h>

using namespace undergrowth;

namespace {

constexpr double STEP = 1.0 / 60.0;

} // namespace

TEST_CASE("a day of steps ends at the end of the day") {
	StepTime time;
	for (int64_t i = 0; i < int64_t(24) * 3600 * 60; i++) {
		time = time.next(STEP);
	}
	CHECK(time.now() == doctest::Approx(24.0 * 3600.0).epsilon(1e-15));
}

TEST_CASE("the time before some steps is the time that it had, to the bit") {
	StepTime time = StepTime().moved_to(3.7);
	StepTime late = time;
	for (int i = 0; i < 7; i++) {
		late = late.next(STEP);
	}
	for (int i = 0; i < 7; i++) {
		CHECK(late.before(7 - i, STEP) == time.now());
		time = time.next(STEP);
	}
}

TEST_CASE("a step of another length continues from now") {
	const StepTime time = StepTime().next(STEP).next(STEP);
	CHECK(time.next(0.032).now() == time.now() + 0.032);
	CHECK(time.before(2, 0.032) == time.now() - 0.064);
}

TEST_CASE("a time that is set has steps of the same length before it") {
	const StepTime time = StepTime().next(STEP).moved_to(5.0);
	CHECK(time.now() == 5.0);
	CHECK(time.before(1, STEP) == time.now() - STEP);
}

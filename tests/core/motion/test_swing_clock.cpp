#include "motion/swing_clock.hpp"

#include <doctest/doctest.h>

using namespace undergrowth;
using doctest::Approx;

TEST_CASE("the clock of swings runs from the previous step to the last one, and restarts after its period") {
	SwingClock clock;
	clock.step(0.5 * SWING_PERIOD);
	clock.step(0.125 * SWING_PERIOD);
	CHECK(clock.now(0.0f) == Approx(0.5));
	CHECK(clock.now(0.5f) == Approx(0.5625));
	CHECK(clock.now(1.0f) == Approx(0.625));
	clock.step(0.5 * SWING_PERIOD);
	CHECK(clock.now(1.0f) == Approx(0.125));
	CHECK(clock.now(0.0f) == Approx(0.625)); // The value before the clock restarted.
}

#include "motion/fixed_step.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

using namespace undergrowth;

namespace {

constexpr double STEP = 1.0 / 60.0;
constexpr float ALPHA_TOLERANCE = 1e-5f;

} // namespace

TEST_CASE("a frame of exactly one step does exactly one step, for hours") {
	FixedStep clock(STEP);
	bool always_one = true;
	for (int i = 0; i < 1000000; i++) {
		always_one = always_one && clock.advance(STEP) == 1;
	}
	CHECK(always_one);
	CHECK(clock.alpha() < ALPHA_TOLERANCE);
}

TEST_CASE("any frame rate does sixty steps a second, without drift over an hour") {
	for (const int rate : { 10, 15, 30, 60, 75, 144, 240 }) {
		FixedStep clock(STEP);
		int steps = 0;
		for (int frame = 0; frame < 3600 * rate; frame++) {
			steps += clock.advance(1.0 / rate);
		}
		CAPTURE(rate);
		CHECK(steps == 3600 * 60);
	}
}

TEST_CASE("alpha is the position of the present between two steps") {
	FixedStep clock(STEP);
	CHECK(clock.alpha() == 0.0f);
	CHECK(clock.advance(0.25 * STEP) == 0);
	CHECK(clock.alpha() == doctest::Approx(0.25f).epsilon(ALPHA_TOLERANCE));
	CHECK(clock.advance(1.5 * STEP) == 1);
	CHECK(clock.alpha() == doctest::Approx(0.75f).epsilon(ALPHA_TOLERANCE));
	CHECK(clock.step() == STEP);
}

TEST_CASE("a frame of ten seconds costs a bounded number of steps and leaves no backlog") {
	FixedStep clock(STEP, 8);
	CHECK(clock.advance(10.0) == 8);
	CHECK(clock.advance(0.0) == 0);
	CHECK(clock.advance(STEP) == 1);
	CHECK(clock.advance(1e300) == 8);
}

TEST_CASE("a frame with the max number of steps leaves no backlog, and preserves the remainder") {
	FixedStep clock(STEP, 8);
	CHECK(clock.advance(8.5 * STEP) == 8);
	CHECK(clock.alpha() == doctest::Approx(0.5f).epsilon(ALPHA_TOLERANCE));
}

TEST_CASE("after a hitch a frame catches up at most an eighth of a second, at any step") {
	FixedStep usual(STEP);
	CHECK(usual.advance(3.0) == 8);
	CHECK(usual.advance(STEP) == 1);
	FixedStep fine(0.001);
	CHECK(fine.advance(0.1) == 100);
	CHECK(fine.advance(3.0) == 134);
	FixedStep coarse(0.1);
	CHECK(coarse.advance(0.2) == 2);
	CHECK(coarse.advance(3.0) == 2);
}

TEST_CASE("a negative or invalid frame counts as none") {
	FixedStep clock(STEP);
	CHECK(clock.advance(-1.0) == 0);
	CHECK(clock.advance(std::numeric_limits<double>::quiet_NaN()) == 0);
	CHECK(clock.advance(std::numeric_limits<double>::infinity()) == 0);
	CHECK(clock.advance(STEP) == 1);
}

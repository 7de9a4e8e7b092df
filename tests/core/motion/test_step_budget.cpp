#include "motion/step_budget.hpp"

#include <doctest/doctest.h>

using namespace undergrowth;

TEST_CASE("a budget without records, or of fast steps, allows all steps") {
	StepBudget budget;
	CHECK(budget.allow(8) == 8);
	CHECK(budget.allow(0) == 0);
	for (int i = 0; i < 3; i++) {
		budget.record(0.001);
	}
	CHECK(budget.allow(8) == 8);
	CHECK(budget.allow(134) == 34);
}

TEST_CASE("after two slow frames a frame begins no step later than the max time") {
	StepBudget budget;
	budget.record(0.012);
	budget.record(0.020);
	CHECK(budget.allow(8) == 3);
	CHECK(budget.allow(2) == 2);
	budget.record(0.5);
	CHECK(budget.allow(8) == 2);
	budget.record(0.5);
	CHECK(budget.allow(8) == 1);
	CHECK(budget.allow(1) == 1);
	CHECK(budget.allow(0) == 0);
}

TEST_CASE("one slow frame among fast ones drops nothing") {
	StepBudget budget;
	budget.record(0.001);
	budget.record(0.5);
	CHECK(budget.allow(8) == 8);
	budget.record(0.001);
	CHECK(budget.allow(8) == 8);
}

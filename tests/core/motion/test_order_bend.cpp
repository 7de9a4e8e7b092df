// The law of parts on swinging parts.

#include "conventions.hpp"
#include "motion/part_bend.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

using namespace undergrowth;

namespace {

PartMotion part_of(float frequency, float damping_ratio = 0.1f, const glm::vec2 &side = { 1.0f, 0.0f }) {
	PartMotion made;
	made.frequency = frequency;
	made.damping_ratio = damping_ratio;
	made.side = side;
	return made;
}

/// Steady motion of an oscillator on a base that swings with the amplitude 1, stepped: the part in phase with the base
/// and the part a quarter of a turn behind it.
glm::dvec2 stepped_response(double ratio, double damping_ratio) {
	constexpr int STEPS = 4000; // Of a period of the base.
	constexpr int PERIODS = 60;
	const double own = 2.0 * PI / ratio; // The base has the period 1.
	const double step = 1.0 / STEPS;
	double place = 0.0;
	double rate = 0.0;
	glm::dvec2 sum(0.0);
	for (int i = 0; i < STEPS * PERIODS; i++) {
		const double turn = 2.0 * PI * static_cast<double>(i) / STEPS;
		const double pull = 4.0 * PI * PI * std::sin(turn); // Minus the acceleration of the base.
		rate += step * (pull - own * own * place - 2.0 * damping_ratio * own * rate);
		place += step * rate;
		if (i >= STEPS * (PERIODS - 1)) {
			sum += 2.0 * step * place * glm::dvec2(std::sin(turn), -std::cos(turn));
		}
	}
	return sum;
}

} // namespace

TEST_CASE("a part on a swinging part responds as an oscillator on a moving base") {
	for (const float ratio : { 0.2f, 0.6f, 0.95f, 1.0f, 1.6f, 4.0f }) {
		for (const float damping_ratio : { 0.1f, 0.3f }) {
			CAPTURE(ratio);
			CAPTURE(damping_ratio);
			const glm::vec2 closed = response_to_base(ratio, damping_ratio);
			const glm::dvec2 stepped = stepped_response(ratio, damping_ratio);
			CHECK(glm::length(glm::dvec2(closed) - stepped) < 0.01 * glm::length(stepped) + 1e-4);
		}
	}
}

TEST_CASE("a twig overshoots a slow branch, lags behind one of its own frequency and stays in place on a fast one") {
	CHECK(response_to_base(0.3f, 0.1f).x > 0.05f);
	CHECK(response_to_base(1.0f, 0.1f).y > 4.0f);
	CHECK(std::abs(response_to_base(1.0f, 0.1f).x) < 1e-4f);
	CHECK(response_to_base(20.0f, 0.1f).x == doctest::Approx(-1.0f).epsilon(0.01));
}

TEST_CASE("without carriers a part has the bend of a part on the stem, to the bit") {
	std::mt19937 chance(3);
	std::uniform_real_distribution<float> any(-1.0f, 1.0f);
	CarrierSwing still;
	still.swing = part_of(1.4f);
	for (int i = 0; i < 1000; i++) {
		StemMotion stem;
		stem.bend = { any(chance), any(chance) };
		stem.rate = { any(chance), any(chance) };
		stem.clock = 0.5f + 0.5f * any(chance);
		stem.air = 4.0f + 4.0f * any(chance);
		const PartMotion part = part_of(2.0f + any(chance));
		CHECK(part_bend(part, stem, nullptr, 0) == part_bend(part, stem));
		CHECK(part_bend(part, stem, &still, 1) == part_bend(part, stem)); // At the base of the carrier.
	}
}

TEST_CASE("a twig is still on a still branch") {
	CarrierSwing branch;
	branch.weight = 0.8f;
	branch.swing = part_of(1.4f);
	StemMotion stem;
	stem.bend = stem.rest = { 0.2f, 0.1f };
	CHECK(part_bend(part_of(2.4f), stem, &branch, 1) == glm::vec2(0.0f));
}

TEST_CASE("a twig lags farther behind a stem that swings than it does without a branch") {
	CarrierSwing branch;
	branch.weight = 1.0f;
	branch.swing = part_of(1.4f);
	StemMotion stem;
	stem.rate = { 0.2f, 0.0f };
	const PartMotion twig = part_of(2.4f, 0.1f, { 0.0f, 1.0f });
	CHECK(part_bend(twig, stem, &branch, 1).x < 1.2f * part_bend(twig, stem).x);
}

TEST_CASE("the bend of a part on swinging parts is bounded and valid for all inputs") {
	std::mt19937 chance(7);
	std::uniform_real_distribution<float> any(-1.0f, 1.0f);
	for (int i = 0; i < 20000; i++) {
		CarrierSwing carriers[MAX_INNER_SWINGS];
		for (CarrierSwing &carrier : carriers) {
			carrier.weight = std::abs(any(chance));
			carrier.swing = part_of(0.125f + 30.0f * std::abs(any(chance)), 2.0f * std::abs(any(chance)));
		}
		const float max = std::pow(10.0f, 4.8f * any(chance));
		StemMotion stem;
		stem.bend = max * glm::vec2(any(chance), any(chance));
		stem.rate = max * glm::vec2(any(chance), any(chance));
		stem.clock = std::abs(any(chance));
		stem.air = max;
		const PartMotion part = part_of(0.125f + 30.0f * std::abs(any(chance)), 2.0f * std::abs(any(chance)));
		const glm::vec2 bend = part_bend(part, stem, carriers, 2);
		REQUIRE(glm::length(bend) <= MAX_PART_BEND * 1.0001f);
		REQUIRE(std::isfinite(bend.x + bend.y));
	}
}

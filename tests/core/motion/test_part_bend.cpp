#include "motion/part_bend.hpp"
#include "motion/swing_clock.hpp"
#include "wind/precipitation.hpp"

#include <doctest/doctest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <random>

using namespace undergrowth;

namespace {

PartMotion leaf(float phase = 0.0f, const glm::vec2 &side = { 1.0f, 0.0f }) {
	PartMotion swing;
	swing.phase = phase;
	swing.side = side;
	return swing;
}

StemMotion blown(const glm::vec2 &bend, float clock = 0.0f) {
	StemMotion stem;
	stem.bend = bend;
	stem.clock = clock;
	stem.air = 2.0f;
	return stem;
}

/// The mean over one second of a clock.
glm::vec2 mean_bend(const PartMotion &part, const glm::vec2 &bend, float air = 2.0f) {
	glm::vec2 sum(0.0f);
	for (int i = 0; i < 2048; i++) {
		StemMotion stem = blown(bend, static_cast<float>(i) / 2048.0f);
		stem.air = air;
		sum += part_bend(part, stem) / 2048.0f;
	}
	return sum;
}

/// Max distance from that mean.
float flutter(const PartMotion &part, const glm::vec2 &bend, float air = 2.0f) {
	const glm::vec2 mean = mean_bend(part, bend, air);
	float max = 0.0f;
	for (int i = 0; i < 2048; i++) {
		StemMotion stem = blown(bend, static_cast<float>(i) / 2048.0f);
		stem.air = air;
		const float away = glm::distance(mean, part_bend(part, stem));
		max = away < 1e-5f ? max : std::max(max, away);
	}
	return max;
}

} // namespace

TEST_CASE("parts of a stem at rest are still at any time, also on a leaning stem") {
	for (const glm::vec2 &rest : { glm::vec2(0.0f), glm::vec2(0.2f, -0.1f) }) {
		for (int i = 0; i < 100; i++) {
			StemMotion stem = blown(rest, static_cast<float>(i) / 100.0f);
			stem.rest = rest;
			stem.air = 0.0f;
			CHECK(part_bend(leaf(0.3f), stem) == glm::vec2(0.0f));
		}
	}
}

TEST_CASE("a part lags behind its stem, and a softer or more damped one lags longer") {
	StemMotion stem;
	stem.rate = { 1.0f, 0.0f };
	PartMotion across = leaf(0.0f, { 0.0f, 1.0f });
	const float lag = -part_bend(across, stem).x;
	CHECK(lag > 0.02f);
	across.frequency = 6.0f;
	CHECK(-part_bend(across, stem).x < 0.7f * lag);
	across.frequency = 3.0f;
	across.damping_ratio = 0.6f;
	CHECK(-part_bend(across, stem).x > 1.3f * lag);
}

TEST_CASE("in steady wind parts lean with it, most on the windward side, and flutter most on the lee side") {
	const glm::vec2 wind(0.2f, 0.0f);
	const float windward = mean_bend(leaf(0.0f, { -1.0f, 0.0f }), wind).x;
	const float aside = mean_bend(leaf(0.0f, { 0.0f, 1.0f }), wind).x;
	const float lee = mean_bend(leaf(0.0f, { 1.0f, 0.0f }), wind).x;
	CHECK(lee > 0.01f);
	CHECK(aside > 1.2f * lee);
	CHECK(windward > lee);
	CHECK(windward < 0.12f); // Not into the stem.
	CHECK(flutter(leaf(0.0f, { 1.0f, 0.0f }), wind) > 1.5f * flutter(leaf(0.0f, { -1.0f, 0.0f }), wind));
}

TEST_CASE("flutter decreases with stiffness and damping") {
	const glm::vec2 wind(0.2f, 0.0f);
	const float usual = flutter(leaf(), wind);
	PartMotion other = leaf();
	other.frequency = 9.0f;
	CHECK(flutter(other, wind) < 0.6f * usual);
	other = leaf();
	other.damping_ratio = 0.8f;
	CHECK(flutter(other, wind) < 0.6f * usual);
}

TEST_CASE("flutter begins at an onset of speed, soon hardly grows, and needs no bend of the stem") {
	const glm::vec2 upright(0.0f);
	CHECK(flutter(leaf(), upright, 0.0f) == 0.0f);
	CHECK(flutter(leaf(), upright, 0.45f) == 0.0f);
	CHECK(flutter(leaf(), upright, 0.6f) > 0.01f);
	CHECK(flutter(leaf(), upright, 1.0f) > 1.4f * flutter(leaf(), upright, 0.6f));
	CHECK(flutter(leaf(), upright, 12.0f) < 1.1f * flutter(leaf(), upright, 4.0f));
	PartMotion stiff = leaf();
	stiff.frequency = 9.0f;
	CHECK(flutter(stiff, upright, 1.0f) == 0.0f);
	CHECK(flutter(stiff, upright, 2.0f) > 0.0f);
}

TEST_CASE("parts of a stem that is held bent in calm air are still") {
	for (const float bend : { 0.1f, 0.5f, 1.0f }) {
		CHECK(flutter(leaf(), { bend, 0.1f }, 0.0f) == 0.0f);
	}
}

TEST_CASE("a source of wind makes parts of bent stems flutter, and those of upright ones not") {
	StemMotion near = blown({ 0.4f, 0.0f });
	near.air = 0.0f;
	const glm::vec2 still = part_bend(leaf(), near);
	near.stirred = 10.0f;
	CHECK(glm::distance(part_bend(leaf(0.25f), near), still) > 0.01f);
	StemMotion far = blown({ 0.0f, 0.0f });
	far.air = 0.0f;
	far.stirred = 10.0f;
	CHECK(part_bend(leaf(0.25f), far) == glm::vec2(0.0f));
}

TEST_CASE("no two phases are in unison") {
	float apart = 0.0f;
	for (int i = 0; i < 256; i++) {
		const StemMotion stem = blown({ 0.2f, 0.1f }, static_cast<float>(i) / 256.0f);
		apart = std::max(apart, glm::distance(part_bend(leaf(0.1f), stem), part_bend(leaf(0.5f), stem)));
	}
	CHECK(apart > 0.03f);
}

TEST_CASE("the room of a part limits its downward turn") {
	PartMotion low = leaf();
	low.room = 0.02f;
	for (int i = 0; i < 256; i++) {
		StemMotion stem = blown({ 1.5f, 0.1f }, static_cast<float>(i) / 256.0f);
		stem.rate = { -10.0f, 0.0f };
		CHECK(part_bend(low, stem).x <= 0.02f);
	}
}

TEST_CASE("a part's bend is bounded and valid, for any motion of its stem and any step") {
	std::mt19937 chance(7);
	std::uniform_real_distribution<float> any(-1.0f, 1.0f);
	for (int i = 0; i < 20000; i++) {
		PartMotion part = leaf(any(chance), { std::cos(10.0f * any(chance)), std::sin(10.0f * any(chance)) });
		part.frequency = 0.125f + 30.0f * std::abs(any(chance));
		part.damping_ratio = 2.0f * std::abs(any(chance));
		const float max = std::pow(10.0f, 4.8f * any(chance));
		const glm::vec2 before = max * glm::vec2(any(chance), any(chance));
		StemMotion stem = blown(max * glm::vec2(any(chance), any(chance)), std::abs(any(chance)));
		stem.rate = (stem.bend - before) * (i % 2 == 0 ? 15.0f : 1000.0f);
		const glm::vec2 bend = part_bend(part, stem);
		REQUIRE(glm::length(bend) <= MAX_PART_BEND * 1.0001f);
		REQUIRE(std::isfinite(bend.x + bend.y));
	}
}

TEST_CASE("parts come to rest with their stem") {
	const PartMotion part = leaf(0.4f, { 0.6f, 0.8f });
	SwingClock clock;
	StemMotion stem;
	float early = 0.0f;
	float late = 0.0f;
	for (int i = 0; i < 1200; i++) {
		clock.step(1.0 / 60.0);
		const float time = static_cast<float>(i) / 60.0f;
		const float size = 0.3f * std::exp(-0.6f * time);
		const glm::vec2 bend(size * std::cos(7.0f * time), 0.3f * size * std::sin(7.0f * time));
		stem.rate = (bend - stem.bend) * 60.0f;
		stem.bend = bend;
		stem.clock = clock.now(1.0f);
		float &max = i < 120 ? early : late;
		if (i < 120 || i >= 1140) {
			max = std::max(max, glm::length(part_bend(part, stem)));
		}
	}
	CHECK(early > 0.05f);
	CHECK(late < 1e-4f);
}

TEST_CASE("nothing jumps when the clock restarts") {
	SwingClock clock;
	clock.step(SWING_PERIOD - 0.1);
	glm::vec2 before(0.0f);
	const PartMotion part = decode_part_motion(encode_part_motion(leaf(0.4f)));
	for (int i = 0; i < 120; i++) {
		clock.step(1.0 / 600.0);
		const glm::vec2 now = part_bend(part, blown({ 0.2f, 0.1f }, clock.now(1.0f)));
		if (i > 0) {
			REQUIRE(glm::distance(now, before) < 0.003f);
		}
		before = now;
	}
}

TEST_CASE("a bent blade preserves its length") {
	for (const float size : { 0.05f, 0.2f, MAX_PART_BEND }) {
		const glm::vec2 bend = size * glm::vec2(0.6f, -0.8f);
		// For a blade in the plane of its bend.
		const glm::vec3 along = 0.4f * glm::normalize(glm::vec3(0.6f * 0.3f, 1.0f, -0.8f * 0.3f));
		float length = 0.0f;
		glm::vec3 before(0.0f);
		for (int i = 1; i <= 1000; i++) {
			const float s = static_cast<float>(i) / 1000.0f;
			const glm::vec3 now = bent_way(along * s, bend, s);
			length += glm::distance(now, before);
			before = now;
		}
		CHECK(length == doctest::Approx(0.4f).epsilon(1e-4));
	}
}

TEST_CASE("drops of rain push leaves outward and let them come to rest within a second") {
	int moved = 0;
	float furthest = 0.0f;
	for (int i = 0; i < 128 * 64; i++) {
		StemMotion stem;
		stem.clock = static_cast<float>(i) / (128.0f * 64.0f);
		stem.drops = 0.25f;
		const glm::vec2 bend = part_bend(leaf(0.3f), stem);
		moved += glm::length(bend) > 1e-4f ? 1 : 0;
		furthest = std::max(furthest, bend.x);
		stem.drops = 0.0f;
		CHECK(part_bend(leaf(0.3f), stem) == glm::vec2(0.0f));
	}
	CHECK(moved > 128 * 64 / 6); // A quarter of the seconds.
	CHECK(moved < 128 * 64 / 3);
	CHECK(furthest > 0.02f);
}

TEST_CASE("leaves in rain move without a jump, also where the clock wraps, and not all at once") {
	constexpr int STEPS = 128 * 256;
	float jump = 0.0f;
	int together = 0;
	for (int i = 0; i <= STEPS; i++) {
		StemMotion stem;
		stem.drops = 0.3f;
		stem.clock = static_cast<float>(i) / STEPS;
		const glm::vec2 before = part_bend(leaf(0.3f), stem);
		together += glm::length(before) > 1e-3f && glm::length(part_bend(leaf(0.55f), stem)) > 1e-3f ? 1 : 0;
		stem.clock = static_cast<float>((i + 1) % STEPS) / STEPS;
		jump = std::max(jump, glm::distance(before, part_bend(leaf(0.3f), stem)));
	}
	CHECK(jump < 0.01f);
	CHECK(together < STEPS / 5);
}

TEST_CASE("heavy rain hits leaves more often than light rain") {
	CHECK(drop_chance({}) == 0.0f);
	CHECK(drop_chance({ 0.0f, 0.0f, 2.0f }) < 0.05f);
	CHECK(drop_chance({ 0.0f, 0.0f, 50.0f }) > 0.6f);
	CHECK(drop_chance({ 0.0f, 0.0f, 1000.0f }) <= 1.0f);
}

#include "wind/source_way.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <initializer_list>

using namespace undergrowth;

namespace {

constexpr float SPEED = 8.0f; // m/s, along x.
constexpr double TICK = 1.0 / 60.0; // s, of physics frames.

/// A node that moves in physics frames, as drawn frames of 1/rate s observe it after `seconds`.
SourceWay moved_in_ticks(int rate, double seconds) {
	SourceWay way;
	way.begin({ 0.0f, 0.0f, 0.0f });
	for (int frame = 1; frame <= static_cast<int>(std::lround(seconds * rate)); frame++) {
		const double ticks = std::floor(frame / (rate * TICK) + 1e-6);
		way.add(1.0 / rate, { SPEED * static_cast<float>(ticks * TICK), 0.0f, 0.0f });
	}
	return way;
}

} // namespace

TEST_CASE("a source's velocity does not depend on the frame rate") {
	for (const int rate : { 30, 60, 75, 120, 144, 240, 1000 }) {
		CAPTURE(rate);
		double sum = 0.0;
		constexpr int STEPS = 60;
		for (int step = 0; step < STEPS; step++) {
			const double seconds = 1.0 + step * TICK;
			const SourceWay way = moved_in_ticks(rate, seconds);
			const double ago = std::lround(seconds * rate) / static_cast<double>(rate) - seconds;
			sum += static_cast<double>(way.velocity(ago > 0.0 ? ago : 0.0).x);
		}
		CHECK(sum / STEPS == doctest::Approx(static_cast<double>(SPEED)).epsilon(0.02));
	}
}

TEST_CASE("between two frames a source is on its straight path") {
	SourceWay way;
	way.begin({ 1.0f, 0.0f, 0.0f });
	way.add(0.1, { 3.0f, 0.0f, 0.0f });
	CHECK(way.place(0.0).x == 3.0f);
	CHECK(way.place(0.025).x == doctest::Approx(2.5));
	CHECK(way.place(5.0).x == 1.0f);
}

TEST_CASE("a source that restarts elsewhere has no earlier velocity") {
	SourceWay way = moved_in_ticks(60, 1.0);
	CHECK(way.velocity(0.0).x > 1.0f);
	way.begin({ 500.0f, 0.0f, 0.0f });
	CHECK(way.velocity(0.0) == glm::vec3(0.0f));
	way.add(TICK, { 500.0f, 0.0f, 0.0f });
	CHECK(way.velocity(0.0) == glm::vec3(0.0f));
	CHECK(way.last().x == 500.0f);
}

#include "conventions.hpp"
#include "wind/wind.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

using namespace undergrowth;

namespace {

constexpr double STRENGTH_TOLERANCE = 1e-5; // Of the strength; floats resolve 6e-8.
constexpr float UNIT_TOLERANCE = 1e-6f;

Wind wind_of(WindKind kind) {
	Wind wind;
	wind.kind = kind;
	wind.strength = 10.0f;
	wind.frequency = 0.5f;
	return wind;
}

} // namespace

TEST_CASE("a constant wind has its strength at all times") {
	const Wind wind = wind_of(WindKind::constant);
	CHECK(wind_strength(wind, -3.0) == 10.0f);
	CHECK(wind_strength(wind, 0.0) == 10.0f);
	CHECK(wind_strength(wind, 1e6) == 10.0f);
}

TEST_CASE("a gust lasts from its start for its duration and is over") {
	Wind wind = wind_of(WindKind::gust);
	wind.gust_start = 2.0;
	wind.gust_duration = 0.5f;
	CHECK(wind_strength(wind, 1.999) == 0.0f);
	CHECK(wind_strength(wind, 2.0) == 10.0f);
	CHECK(wind_strength(wind, 2.499) == 10.0f);
	CHECK(wind_strength(wind, 2.5) == 0.0f);
	wind.gust_triggered = true;
	CHECK(wind_strength(wind, 2.2) == 10.0f);
}

TEST_CASE("a triggered gust adds to the other kinds") {
	Wind wind = wind_of(WindKind::constant);
	wind.gust_start = 2.0;
	CHECK(wind_strength(wind, 2.2) == 10.0f);
	wind.gust_triggered = true;
	CHECK(wind_strength(wind, 2.2) == 20.0f);
	CHECK(wind_strength(wind, 2.6) == 10.0f);
}

TEST_CASE("strength and length of a triggered gust end with its flag") {
	Wind wind = wind_of(WindKind::gust);
	wind.strength = 8.0f;
	wind.gust_duration = 0.5f;
	wind.triggered_strength = 3.0f;
	wind.triggered_duration = 2.0f;
	wind.gust_triggered = false;
	CHECK(gust_strength(wind) == 8.0f);
	CHECK(gust_duration(wind) == 0.5f);
}

TEST_CASE("a triggered gust can have its own strength and length") {
	for (const WindKind kind : { WindKind::constant, WindKind::gust }) {
		Wind wind = wind_of(kind);
		wind.gust_start = 2.0;
		wind.triggered_strength = 3.0f;
		wind.triggered_duration = 1.5f;
		const float calm = kind == WindKind::constant ? 10.0f : 0.0f;
		CHECK(wind_strength(wind, 2.2) == 10.0f); // No gust was triggered.
		wind.gust_triggered = true;
		CHECK(wind_strength(wind, 1.9) == calm);
		CHECK(wind_strength(wind, 3.4) == calm + 3.0f);
		CHECK(wind_strength(wind, 3.6) == calm);
		wind.triggered_strength = 0.0f;
		CHECK(wind_strength(wind, 2.2) == calm);
	}
}

TEST_CASE("bursts fill the first half of each period and stop fully in the second") {
	Wind wind = wind_of(WindKind::bursts);
	CHECK(wind_strength(wind, 0.0) == 10.0f);
	CHECK(wind_strength(wind, 0.99) == 10.0f);
	CHECK(wind_strength(wind, 1.0) == 0.0f);
	CHECK(wind_strength(wind, 1.99) == 0.0f);
	CHECK(wind_strength(wind, 2.0) == 10.0f);
	CHECK(wind_strength(wind, -0.5) == 0.0f);
	wind.phase = 0.5;
	CHECK(wind_strength(wind, 0.0) == 0.0f);
	wind.phase = -1e-20; // Rounds to a whole cycle, which is the start of the next.
	CHECK(wind_strength(wind, 0.0) == 10.0f);
}

TEST_CASE("waves are a sine about the strength with the strength as amplitude") {
	Wind wind = wind_of(WindKind::waves);
	wind.frequency = 0.7f;
	wind.phase = 0.3;
	double worst = 0.0;
	for (int i = 0; i < 5000; i++) {
		const double time = i * 0.731;
		const double cycles = static_cast<double>(wind.frequency) * time + wind.phase;
		const double expected = 10.0 * (1.0 + std::sin(2.0 * PI * cycles));
		worst = std::fmax(worst, std::fabs(static_cast<double>(wind_strength(wind, time)) - expected));
	}
	CHECK(worst < 10.0 * STRENGTH_TOLERANCE);
}

TEST_CASE("waves range from zero to twice the strength") {
	Wind wind = wind_of(WindKind::waves);
	wind.frequency = 1.0f;
	CHECK(wind_strength(wind, 0.25) == doctest::Approx(20.0).epsilon(STRENGTH_TOLERANCE));
	CHECK(wind_strength(wind, 0.75) == doctest::Approx(0.0).epsilon(STRENGTH_TOLERANCE));
}

TEST_CASE("wind without strength or frequency is still a number") {
	Wind wind = wind_of(WindKind::waves);
	wind.frequency = 0.0f;
	CHECK(wind_strength(wind, 12.0) == doctest::Approx(10.0).epsilon(STRENGTH_TOLERANCE));
	wind.strength = 0.0f;
	CHECK(wind_strength(wind, 12.0) == 0.0f);
}

TEST_CASE("direction 0 points towards +z, a quarter turn towards +x") {
	Wind wind;
	wind.direction = 0.0f;
	CHECK(wind_direction(wind).x == doctest::Approx(0.0f).epsilon(UNIT_TOLERANCE));
	CHECK(wind_direction(wind).z == doctest::Approx(1.0f).epsilon(UNIT_TOLERANCE));
	wind.direction = static_cast<float>(0.5 * PI);
	CHECK(wind_direction(wind).x == doctest::Approx(1.0f).epsilon(UNIT_TOLERANCE));
	CHECK(wind_direction(wind).z == doctest::Approx(0.0f).epsilon(UNIT_TOLERANCE));
	CHECK(wind_direction(wind).y == 0.0f);
}

TEST_CASE("the force is the direction times the strength") {
	Wind wind = wind_of(WindKind::constant);
	wind.direction = 0.4f;
	const glm::vec3 force = wind_force(wind, 1.0);
	CHECK(force.x == doctest::Approx(10.0 * std::sin(0.4)).epsilon(STRENGTH_TOLERANCE));
	CHECK(force.y == 0.0f);
	CHECK(force.z == doctest::Approx(10.0 * std::cos(0.4)).epsilon(STRENGTH_TOLERANCE));
}

TEST_CASE("changing the frequency preserves the phase of the wave") {
	Wind wind = wind_of(WindKind::waves);
	for (int i = 0; i < 100; i++) {
		const double time = 1000.0 + i * 17.3;
		const float before = wind_strength(wind, time);
		change_frequency(wind, 0.1f + 0.07f * static_cast<float>(i), time);
		CHECK(wind_strength(wind, time) == doctest::Approx(before).epsilon(STRENGTH_TOLERANCE));
		CHECK(wind.phase >= 0.0);
		CHECK(wind.phase < 1.0);
	}
}

#include "motion/motion_page.hpp"
#include "wind/field_wind.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <initializer_list>
#include <vector>

using namespace undergrowth;

TEST_CASE("plants along the wind move equally, later by distance over speed") {
	constexpr int LATE = 30; // Steps.
	constexpr float STEP = 1.0f / 60.0f; // s.
	constexpr float SHIFT_TOLERANCE = 2e-4f;
	FieldWind wind;
	wind.wind.kind = WindKind::waves;
	wind.wind.strength = 1.5f;
	wind.wind.direction = 0.7f;
	wind.speed = 6.0f;
	for (const Law law : { Law::elasticity, Law::spring }) {
		MotionSpecies species;
		species.law = law;
		species.joint.mass = 0.4f;
		MotionPlant plants[2];
		plants[1].root = wind_direction(wind.wind) * (wind.speed * STEP * LATE);
		MotionPage page(0, species, plants, 2, STEP, true);
		std::vector<glm::vec3> first, second;
		for (int i = 0; i < 3000; i++) {
			const double time = (i + page.wind_moment()) * static_cast<double>(STEP);
			page.step(wind_at_time(wind, time), winds_along(wind));
			first.push_back(page.direction(0));
			second.push_back(page.direction(1));
		}
		// After 30 s of damping the start has no effect.
		for (size_t i = 2000; i < 3000; i++) {
			REQUIRE(glm::distance(second[i], first[i - LATE]) < SHIFT_TOLERANCE);
		}
	}
}

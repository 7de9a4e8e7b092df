#include "swing.hpp"

#include <doctest/doctest.h>

using namespace undergrowth;

TEST_CASE("a plant of the elasticity law with much friction rises by its equation, at any step") {
	Joint joint;
	joint.mass = 0.4f;
	joint.elasticity = 4.0f;
	const double omega_squared = 4.0 * 9.81;
	for (const float friction : { 5.5f, 10.0f, 40.0f }) {
		joint.inner_friction = friction;
		const double beta = 0.5 * static_cast<double>(friction) / 0.4;
		REQUIRE(beta * beta > omega_squared);
		const double slow = omega_squared / (beta + std::sqrt(beta * beta - omega_squared));
		for (const float step : { FRAME_STEP, LONG_STEP }) {
			MotionPage page = plant_page(Law::elasticity, joint, leaning(0.02), step);
			const auto second = static_cast<std::size_t>(std::lround(1.0f / step));
			const std::vector<double> places = record_x(page, static_cast<int>(2 * second + 2));
			const double time = static_cast<double>(second) * static_cast<double>(step);
			CHECK(std::log(places[second] / places[2 * second]) / time == doctest::Approx(slow).epsilon(0.01));
		}
	}
}

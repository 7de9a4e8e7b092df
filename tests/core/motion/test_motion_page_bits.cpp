#include "varied.hpp"

#include "../field/allocations.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace undergrowth;

TEST_CASE("any division of plants into pages, at every level, gives the same bits") {
	for (const Law law : BOTH_LAWS) {
		MotionPage whole = meadow(law, 0, 601);
		MotionPage best = meadow(law, 0, 601);
		MotionPage first = meadow(law, 0, 123);
		MotionPage rest = meadow(law, 123, 478);
		for (int i = 0; i < 300; i++) {
			apply_wind(whole, i, SimdLevel::baseline);
			apply_wind(best, i, SimdLevel::avx2);
			apply_wind(first, i, i % 2 == 0 ? SimdLevel::avx2 : SimdLevel::baseline);
			apply_wind(rest, i);
		}
		CHECK(hash_states(whole) == hash_states(best));
		for (int i = 0; i < 601; i++) {
			REQUIRE(same_bits(whole.state(i), i < 123 ? first.state(i) : rest.state(i - 123)));
		}
	}
}

TEST_CASE("a step of a page with directions allocates nothing") {
	for (const Law law : BOTH_LAWS) {
		MotionPage page = meadow(law, 0, 1000);
		std::vector<glm::vec3> drawn(1000);
		apply_wind(page, 0);
		const long before = allocation_count();
		for (int i = 1; i < 30; i++) {
			apply_wind(page, i);
			page.interpolate(0.5f, drawn.data());
		}
		CHECK(allocation_count() == before);
	}
}

TEST_CASE("no joint, state or wind, however extreme, causes an invalid number") {
	constexpr float NONE = std::numeric_limits<float>::quiet_NaN();
	constexpr float INF = std::numeric_limits<float>::infinity();
	constexpr float EXTREMES[] = { 0.0f, 1e-30f, 1e-6f, 1.0f, 1e6f, 1e30f, -1.0f, NONE, INF };
	std::vector<MotionPage> pages;
	for (const Law law : BOTH_LAWS) {
		for (const float a : EXTREMES) {
			for (const float b : EXTREMES) {
				Joint joint;
				joint.mass = b;
				joint.length = std::isfinite(a) && a > 0.0f ? a : 1.0f;
				pages.push_back(plant_page(law, joint, leaning(1.0)));
				joint = Joint{};
				joint.elasticity = a;
				joint.inner_friction = b;
				joint.natural_frequency = a;
				joint.damping_ratio = b;
				pages.push_back(plant_page(law, joint, leaning(-0.5)));
				joint.length = 1e-3f;
				joint.mass = 1e-3f;
				joint.wind_weight = a;
				joint.above_ground = false;
				pages.push_back(plant_page(law, joint, { { a, b, 1.0f }, { b, a, a } }));
			}
		}
	}
	const float strengths[] = { 1e6f, 0.0f, NONE, 1e30f, INF };
	for (MotionPage &page : pages) {
		for (int i = 0; i < 500; i++) {
			FieldWind wind;
			wind.wind.strength = strengths[(i / 7) % 5];
			wind.wind.direction = (i / 7) % 5 == 2 ? NONE : static_cast<float>(i);
			page.step(wind_at_time(wind, i), winds_along(wind));
			if (i % 100 == 0) {
				page.apply_impulse(0, { 1e6f, -1e6f, NONE });
				page.apply_impulse(0, { 1e6f, -1e6f, 1e30f });
			}
		}
		glm::vec3 drawn;
		page.interpolate(0.5f, &drawn);
		REQUIRE(is_finite(page.state(0)));
		REQUIRE(std::fabs(glm::length(page.state(0).direction) - 1.0f) < 4.0f * STATE_TOLERANCE);
		REQUIRE(std::fabs(glm::length(drawn) - 1.0f) < 4.0f * STATE_TOLERANCE);
	}
}

TEST_CASE("a run of each law has the same bits on every platform") {
	constexpr uint64_t ELASTICITY_GOLDEN = 0xb68b263b2a6dc52aull;
	constexpr uint64_t SPRING_GOLDEN = 0x60ec898e2215eba4ull;
	for (const Law law : BOTH_LAWS) {
		MotionPage page = meadow(law, 0, 50);
		for (int i = 0; i < 600; i++) {
			apply_wind(page, i);
		}
		CHECK(hash_states(page) == (law == Law::elasticity ? ELASTICITY_GOLDEN : SPRING_GOLDEN));
	}
}

#include "field/trodden_plants.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace undergrowth;

TEST_CASE("absent trodden plants recover in the time of their species") {
	TroddenPlants plants;
	plants.put(7, { 0.5f, 0.0f }, 100.0f);
	plants.advance(50.0);
	plants.put(3, { 0.0f, -0.4f }, 10.0f);
	plants.advance(50.0);
	const std::vector<TroddenPlant> all = plants.all();
	REQUIRE(all.size() == 2);
	CHECK(all[0].id == 3);
	CHECK(all[0].bend.y == doctest::Approx(-0.4 * std::exp(-5.0)).epsilon(1e-4));
	CHECK(all[1].bend.x == doctest::Approx(0.5 * std::exp(-1.0)).epsilon(1e-4));
	CHECK(plants.take(7).x == all[1].bend.x);
	CHECK(plants.take(7) == glm::vec2(0.0f));
	CHECK(plants.count() == 1);
	plants.advance(1000.0);
	CHECK(plants.all().empty());
	CHECK(plants.take(3) == glm::vec2(0.0f));
	CHECK(plants.is_empty());
}

TEST_CASE("upright plants are not stored, and recovered ones are removed before there are many") {
	TroddenPlants plants;
	plants.put(1, { 0.3f, 0.0f }, 10.0f);
	plants.put(1, { 0.0f, 0.0f }, 10.0f);
	CHECK(plants.is_empty());
	for (int round = 0; round < 100; round++) {
		for (int i = 0; i < 500; i++) {
			plants.put(500 * round + i, { 0.3f, 0.0f }, 1.0f);
		}
		plants.advance(60.0);
		CHECK(plants.count() <= 2048);
	}
}

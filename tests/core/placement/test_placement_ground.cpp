#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>
#include <glm/vec3.hpp>

#include <cmath>
#include <limits>

using namespace undergrowth;

namespace {

/// The normal of ground that rises by `slope` rad towards +x.
glm::vec3 normal_of(double slope) {
	return { static_cast<float>(-std::sin(slope)), static_cast<float>(std::cos(slope)), 0.0f };
}

/// True if a plant on ground of this height and slope (rad) stays.
bool stays(float height, double slope, const GroundLimits &limits) {
	FieldPlants plants;
	plants.add({});
	const glm::vec3 normal = normal_of(slope);
	return apply_ground(plants, &height, &normal, limits) == 1;
}

} // namespace

TEST_CASE("plants get the ground's height and preserve their order") {
	FieldPlants plants = placed(square_field(20.0f, 5.0f, 3));
	const FieldPlants before = plants;
	std::vector<float> heights;
	for (int i = 0; i < plants.size(); i++) {
		heights.push_back(i % 3 == 0 ? -5.0f : static_cast<float>(i) * 0.25f);
	}
	GroundLimits limits;
	limits.lowest = 0.0f;
	const int kept = apply_ground(plants, heights.data(), nullptr, limits);
	CHECK(kept == plants.size());
	REQUIRE(kept == before.size() - (before.size() + 2) / 3);
	int next = 0;
	for (int i = 0; i < before.size(); i++) {
		if (i % 3 == 0) {
			continue;
		}
		const PlacedPlant was = before.plant(i);
		const PlacedPlant is = plants.plant(next++);
		CHECK(is.root == glm::vec3(was.root.x, static_cast<float>(i) * 0.25f, was.root.z));
		CHECK(is.turn == was.turn);
		CHECK(is.scale == was.scale);
		CHECK(is.height == was.height);
		CHECK(is.lean == was.lean);
		CHECK(is.species == was.species);
		CHECK(is.variant == was.variant);
	}
}

TEST_CASE("plants lean with the ground by their alignment") {
	constexpr double SLOPE = 0.5;
	constexpr double TOLERANCE = 2e-4; // rad: rounding of the codes and of the normal.
	const float height = 1.0f;
	const glm::vec3 normal = 3.0f * normal_of(SLOPE);
	for (const float turn : { 0.0f, 1.0f, 4.0f }) {
		PlacedPlant upright;
		upright.turn = turn;
		FieldPlants plants;
		plants.add(upright);
		GroundLimits limits;
		apply_ground(plants, &height, &normal, limits);
		CHECK(plants.plant(0).lean == 0.0f);
		limits.alignment = 1.0f;
		apply_ground(plants, &height, &normal, limits);
		const PlacedPlant aligned = plants.plant(0);
		CHECK(aligned.turn == doctest::Approx(turn).epsilon(TOLERANCE));
		CHECK(std::abs(aligned.lean - SLOPE) < TOLERANCE);
		// The normal leans to -x: half a turn from the field's +x.
		CHECK(std::abs(std::cos(aligned.turn + aligned.side) + 1.0) < TOLERANCE);
		// A plant with the same lean uphill becomes upright.
		PlacedPlant uphill = upright;
		uphill.lean = static_cast<float>(SLOPE);
		uphill.side = -turn;
		FieldPlants others;
		others.add(uphill);
		apply_ground(others, &height, &normal, limits);
		CHECK(others.plant(0).lean < TOLERANCE);
	}
}

TEST_CASE("half an alignment leans plants by half, and level ground does not lean them") {
	const float height = 0.0f;
	const glm::vec3 normal = normal_of(0.2);
	const glm::vec3 level = { 0.0f, 1.0f, 0.0f };
	GroundLimits limits;
	limits.alignment = 0.5f;
	FieldPlants plants;
	plants.add({});
	apply_ground(plants, &height, &normal, limits);
	CHECK(plants.plant(0).lean == doctest::Approx(0.1).epsilon(0.01));
	FieldPlants flat;
	PlacedPlant leaning;
	leaning.lean = 0.3f;
	leaning.side = 1.0f;
	flat.add(leaning);
	apply_ground(flat, &height, &level, limits);
	CHECK(flat.plant(0).lean == doctest::Approx(0.3).epsilon(1e-3));
	CHECK(flat.plant(0).side == doctest::Approx(1.0).epsilon(1e-3));
}

TEST_CASE("plants that are aligned with a ceiling stay valid") {
	for (const float alignment : { 0.5f, 1.0f }) {
		PlacedPlant plant;
		FieldPlants plants;
		plants.add(plant);
		GroundLimits limits;
		limits.alignment = alignment;
		const float height = 0.0f;
		const glm::vec3 down = { 0.0f, -1.0f, 0.0f };
		REQUIRE(apply_ground(plants, &height, &down, limits) == 1);
		CHECK(is_valid(plants.plant(0)));
	}
}

TEST_CASE("limits of height and slope are inclusive") {
	GroundLimits limits;
	limits.lowest = -1.0f;
	limits.highest = 2.0f;
	limits.flattest = 0.2f;
	limits.steepest = 0.7f;
	CHECK(stays(-1.0f, 0.5, limits));
	CHECK(stays(2.0f, 0.5, limits));
	CHECK_FALSE(stays(-1.001f, 0.5, limits));
	CHECK_FALSE(stays(2.001f, 0.5, limits));
	CHECK(stays(0.0f, 0.2, limits));
	CHECK(stays(0.0f, 0.7, limits));
	CHECK_FALSE(stays(0.0f, 0.199, limits));
	CHECK_FALSE(stays(0.0f, 0.701, limits));
	CHECK_FALSE(stays(0.0f, 3.0, limits));
}

TEST_CASE("without limits plants grow on walls and ceilings, but never without ground") {
	const float nan = std::numeric_limits<float>::quiet_NaN();
	const float infinity = std::numeric_limits<float>::infinity();
	CHECK(stays(0.0f, 0.0, {}));
	CHECK(stays(-1.0e6f, 1.57, {}));
	CHECK(stays(1.0e6f, 3.14159265, {}));
	CHECK_FALSE(stays(nan, 0.0, {}));
	CHECK_FALSE(stays(infinity, 0.0, {}));
	const float level = 0.0f;
	for (const glm::vec3 &normal : { glm::vec3(0.0f), glm::vec3(nan, 1, 0), glm::vec3(infinity, 1, 0) }) {
		FieldPlants plants;
		plants.add({});
		CHECK(apply_ground(plants, &level, &normal, {}) == 0);
	}
}

TEST_CASE("normals can have any length, and level ground has no slope") {
	GroundLimits level;
	level.steepest = 0.0f;
	CHECK(stays(0.0f, 0.0, level));
	const float height = 1.0f;
	const glm::vec3 normal = { 0.0f, 1.0e-6f, 0.0f };
	FieldPlants plants;
	plants.add({});
	CHECK(apply_ground(plants, &height, &normal, level) == 1);
}

TEST_CASE("a stored plant is restored to the stated precision") {
	FieldPlants plants;
	for (int i = -50; i < 50; i++) {
		PlacedPlant plant;
		plant.root = { 1.5f, -2.25f, static_cast<float>(i) };
		plant.scale = 0.75f;
		plant.turn = static_cast<float>(i) * 0.4f;
		plant.height = 0.1f + static_cast<float>(i + 50) * 0.07f;
		plant.lean = static_cast<float>(i + 50) * 0.0157f;
		plant.species = i + 50;
		plant.variant = 255;
		REQUIRE(plants.add(plant));
		const PlacedPlant back = plants.plant(plants.size() - 1);
		CHECK(back.root == plant.root);
		CHECK(back.scale == plant.scale);
		CHECK(std::abs(std::remainder(back.turn - plant.turn, 6.2831853f)) < 1.0e-4f);
		CHECK(std::abs(back.height - plant.height) < 1.3e-4f);
		CHECK(std::abs(back.lean - plant.lean) < 2.4e-5f);
		CHECK(back.species == plant.species);
		CHECK(back.variant == 255);
	}
	PlacedPlant usual;
	plants.add(usual);
	CHECK(plants.plant(100).height == 1.0f);
	CHECK(plants.plant(100).lean == 0.0f);
}

TEST_CASE("invalid plants are omitted") {
	const float nan = std::numeric_limits<float>::quiet_NaN();
	FieldPlants plants;
	std::vector<PlacedPlant> broken(8);
	broken[0].root.y = nan;
	broken[1].scale = nan;
	broken[2].turn = std::numeric_limits<float>::infinity();
	broken[3].height = nan;
	broken[4].lean = nan;
	broken[5].scale = 0.0f;
	broken[6].species = 256;
	broken[7].variant = -1;
	for (const PlacedPlant &plant : broken) {
		CHECK_FALSE(plants.add(plant));
	}
	CHECK(plants.size() == 0);
	PlacedPlant tall;
	tall.height = 100.0f;
	tall.lean = -1.0f;
	CHECK(plants.add(tall));
	CHECK(plants.plant(0).height == doctest::Approx(8.0).epsilon(1e-4));
	CHECK(plants.plant(0).lean == 0.0f);
}

TEST_CASE("removal preserves the order of the remaining plants, and a plant costs 28 bytes") {
	const FieldPlants all = placed(square_field(10.0f, 3.0f, 2));
	FieldPlants plants = all;
	const int last = all.size() - 1;
	plants.remove({ 0, 5, 6, last });
	REQUIRE(plants.size() == all.size() - 4);
	CHECK(plants.plant(0).root == all.plant(1).root);
	CHECK(plants.plant(4).root == all.plant(7).root);
	CHECK(plants.plant(plants.size() - 1).root == all.plant(last - 1).root);
	plants.remove({});
	CHECK(plants.size() == all.size() - 4);
	FieldPlants exact;
	exact.reserve(1000);
	CHECK(exact.bytes() == 1000 * FieldPlants::PLANT_BYTES);
}

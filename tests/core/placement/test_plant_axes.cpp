#include "base/portable_math.hpp"
#include "conventions.hpp"
#include "placement/plant_axes.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

using namespace undergrowth;

namespace {

/// A unit vector that leans by `lean` from upright, towards `around` (rad from +z towards +x).
glm::vec3 leaning(double lean, double around) {
	return { static_cast<float>(portable_sin(lean) * portable_sin(around)), static_cast<float>(portable_cos(lean)),
		static_cast<float>(portable_sin(lean) * portable_cos(around)) };
}

/// The vector nearest to `wanted` at right angles to `up`.
glm::vec3 squared(const glm::vec3 &wanted, const glm::vec3 &up) {
	return glm::normalize(wanted - glm::dot(wanted, up) * up);
}

} // namespace

TEST_CASE("a plant placed by a transform points along its y axis and has its length") {
	for (const double lean : { 0.0, 0.002, 0.3, 1.2 }) {
		for (const double around : { 0.0, 0.7, 2.0, -2.5 }) {
			const glm::vec3 up = leaning(lean, around);
			const PlacedPlant plant = plant_of_axes({ 1.0f, 2.0f, 3.0f }, 2.5f * up, squared({ 0.2f, 0.0f, 1.0f }, up));
			CHECK(plant.root == glm::vec3(1.0f, 2.0f, 3.0f));
			CHECK(plant.scale == doctest::Approx(2.5));
			CHECK(plant.lean == doctest::Approx(lean).epsilon(1e-4));
			CHECK(glm::distance(rest_direction(plant, 0.0f), up) < 1e-5f);
		}
	}
}

TEST_CASE("a plant placed upright has the turn of its transform and no lean") {
	for (const double turn : { 0.0, 1.0, -3.0 }) {
		const PlacedPlant plant = plant_of_axes({}, { 0.0f, 1.0f, 0.0f }, leaning(0.5 * PI, turn));
		CHECK(plant.turn == doctest::Approx(turn));
		CHECK(plant.lean == 0.0f);
		CHECK(plant.side == 0.0f);
	}
}

TEST_CASE("a tilt does not change a plant's turn about its stem") {
	for (const double around : { 0.0, 0.7, -2.5 }) {
		const glm::vec3 up = leaning(0.6, around);
		const glm::vec3 across = leaning(0.5 * PI, around + 0.5 * PI);
		const glm::vec3 level_front = leaning(0.5 * PI, 1.2);
		// Turned by 0.6 rad about `across`, like `up`.
		const glm::vec3 front = static_cast<float>(portable_cos(0.6)) * level_front +
				static_cast<float>(portable_sin(0.6)) * glm::cross(across, level_front) +
				static_cast<float>(1.0 - portable_cos(0.6)) * glm::dot(across, level_front) * across;
		CHECK(plant_of_axes({}, up, front).turn == doctest::Approx(1.2));
	}
}

TEST_CASE("a species' own lean follows the turn of its plants") {
	PlacedPlant plant;
	plant.turn = 1.1f;
	CHECK(glm::distance(rest_direction(plant, 0.4f), leaning(0.4, 1.1)) < 1e-6f);
}

TEST_CASE("no plant rests below the ground, for any placement") {
	PlacedPlant plant;
	plant.lean = static_cast<float>(0.5 * PI);
	for (float side = 0.0f; side < 6.0f; side += 0.5f) {
		plant.side = side;
		for (const float species_lean : { 0.0f, 0.7f, 1.39f }) {
			const glm::vec3 rest = rest_direction(plant, species_lean);
			CHECK(rest.y >= 0.1699f); // cos 1.4.
			CHECK(glm::length(rest) == doctest::Approx(1.0));
		}
	}
}

TEST_CASE("a transform without a size, or that is not finite, gives no plant") {
	CHECK(!is_valid(plant_of_axes({}, glm::vec3(0.0f), { 0.0f, 0.0f, 1.0f })));
	CHECK(!is_valid(plant_of_axes({}, { 0.0f, std::numeric_limits<float>::infinity(), 0.0f }, { 0.0f, 0.0f, 1.0f })));
	CHECK(!is_valid(plant_of_axes({ NAN, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f }, { 0.0f, 0.0f, 1.0f })));
}

#include "placement/clump.hpp"
#include "placement/placement.hpp"
#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <vector>

using namespace undergrowth;

namespace {

constexpr double TAU = 6.28318530717958648;

/// Length of the mean of unit vectors with the turns of all plants within `reach` of a point: 1 if all are equal.
double agreement(const FieldPlants &plants, glm::vec2 middle, float reach) {
	double x = 0.0;
	double z = 0.0;
	int count = 0;
	for (int i = 0; i < plants.size(); i++) {
		const PlacedPlant plant = plants.plant(i);
		if (std::abs(plant.root.x - middle.x) < reach && std::abs(plant.root.z - middle.y) < reach) {
			x += std::cos(static_cast<double>(plant.turn));
			z += std::sin(static_cast<double>(plant.turn));
			count++;
		}
	}
	return count > 0 ? std::sqrt(x * x + z * z) / count : 0.0;
}

PlacementRequest combed_field(float combed) {
	PlacementRequest request = square_field(30.0f, 20.0f, 1);
	request.combed = combed;
	request.seed = 7;
	request.species[0].height_deviation = 0.0f;
	return request;
}

} // namespace

TEST_CASE("clumps are cells of about a square metre") {
	std::set<double> heights;
	double edges = 0.0;
	double before = 2.0;
	for (int j = 0; j < 100; j++) {
		for (int i = 0; i < 1000; i++) {
			const Clump clump = clump_at(0.02 * i, 0.2 * j);
			heights.insert(clump.height);
			edges += clump.height != before ? 1.0 : 0.0;
			before = clump.height;
			CHECK(clump.lean >= 0.4);
			CHECK(clump.lean <= 1.0);
			CHECK(std::abs(clump.height) <= 1.0);
		}
	}
	const double area = 20.0 * 20.0 / static_cast<double>(heights.size());
	CHECK(area > 0.6 * 0.6);
	CHECK(area < 1.2 * 1.2);
	const double chord = 20.0 * 100.0 / edges; // m, mean width of a clump along a line.
	CHECK(chord > 0.4);
	CHECK(chord < 1.2);
}

TEST_CASE("neighbouring clumps have similar directions, distant ones do not") {
	double near = 0.0;
	double far = 0.0;
	const int count = 400;
	for (int i = 0; i < count; i++) {
		const double x = 37.0 * i;
		near += std::cos(clump_at(x, 5.0).turn - clump_at(x + 1.5, 5.0).turn) / count;
		far += std::cos(clump_at(x, 5.0).turn - clump_at(x + 15.0, 5.0).turn) / count;
	}
	CHECK(near > 0.9);
	CHECK(far < near - 0.05);
}

TEST_CASE("clumps are the same on every platform") {
	GoldenHash hash;
	for (int i = 0; i < 1000; i++) {
		const Clump clump = clump_at(1.7 * i - 800.0, 900.0 - 2.3 * i);
		hash.add(std::vector<double>{ clump.turn, clump.lean, clump.height });
	}
	CHECK(hash.value() == 2919785815332163884ull);
}

TEST_CASE("combing aligns plants and moves none") {
	const FieldPlants free = placed(combed_field(0.0f));
	const FieldPlants half = placed(combed_field(0.6f));
	const FieldPlants whole = placed(combed_field(1.0f));
	CHECK(agreement(free, { 2.0f, 3.0f }, 1.5f) < 0.4);
	CHECK(agreement(half, { 2.0f, 3.0f }, 1.5f) > 0.8);
	CHECK(agreement(whole, { 2.0f, 3.0f }, 1.5f) > 0.85);
	CHECK(half.x == free.x);
	CHECK(half.z == free.z);
	CHECK(half.scale == free.scale);
	CHECK(half.species == free.species);
	CHECK(half.variant == free.variant);
}

TEST_CASE("combed plants lean to their front, at most as far as their species does") {
	PlacementRequest request = combed_field(1.0f);
	request.species[0].max_lean = 0.2f;
	const FieldPlants plants = placed(request);
	REQUIRE(plants.size() > 1000);
	double sum = 0.0;
	for (int i = 0; i < plants.size(); i++) {
		const PlacedPlant plant = plants.plant(i);
		CHECK(plant.lean <= 0.2f + 1e-4f);
		CHECK(std::abs(static_cast<double>(plant.side) - 0.75 * TAU) < 1e-3);
		sum += static_cast<double>(plant.lean) / plants.size();
	}
	CHECK(sum > 0.1);
	request.species[0].max_lean = 0.0f;
	for (const uint16_t lean : placed(request).lean) {
		CHECK(lean == 0);
	}
}

TEST_CASE("the mean height of combed plants is that of others") {
	double sum = 0.0;
	double squares = 0.0;
	const FieldPlants plants = placed(combed_field(1.0f));
	for (int i = 0; i < plants.size(); i++) {
		const double height = static_cast<double>(plants.plant(i).height);
		sum += height / plants.size();
		squares += height * height / plants.size();
	}
	CHECK(std::abs(sum - 1.0) < 0.03);
	CHECK(std::sqrt(squares - sum * sum) > 0.1);
}

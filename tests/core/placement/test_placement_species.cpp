#include "placement/placement.hpp"
#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

using namespace undergrowth;

namespace {

std::vector<int> species_counts(const FieldPlants &plants) {
	std::vector<int> counts(256, 0);
	for (const uint8_t species : plants.species) {
		counts[species]++;
	}
	return counts;
}

/// Fraction of plants that have the species of the plant placed before them.
double likeness(const FieldPlants &plants) {
	int alike = 0;
	for (std::size_t i = 1; i < plants.species.size(); i++) {
		alike += plants.species[i] == plants.species[i - 1];
	}
	return static_cast<double>(alike) / static_cast<double>(plants.size() - 1);
}

} // namespace

TEST_CASE("species occur by their weights, with and without clumping") {
	// The fraction of a species in a field of n independent draws has a standard deviation of sqrt(p·(1 - p)/n).
	PlacementRequest request = square_field(200.0f, 2.0f, 4);
	const double shares[] = { 6.0, 0.0, 3.0, 1.0 };
	for (std::size_t i = 0; i < 4; i++) {
		request.species[i].weight = static_cast<float>(shares[i]);
	}
	for (const float clumping : { 0.0f, 0.5f, 1.0f }) {
		request.clumping = clumping;
		const FieldPlants plants = placed(request);
		const double draws = clumping == 0.0f ? plants.size() : 200.0 * 200.0 / 9.0;
		const std::vector<int> counts = species_counts(plants);
		for (std::size_t i = 0; i < 4; i++) {
			const double p = shares[i] / 10.0;
			const double share = static_cast<double>(counts[i]) / plants.size();
			CAPTURE(i);
			// Drifts have different sizes, so the effective number of draws is lower.
			CHECK(std::abs(share - p) <= 5.0 * std::sqrt(p * (1.0 - p) / draws));
		}
		CHECK(counts[1] == 0);
	}
}

TEST_CASE("clumping makes neighbours equal; without clumping they are random") {
	PlacementRequest request = square_field(100.0f, 10.0f, 5);
	const double apart = likeness(placed(request));
	request.clumping = 0.5f;
	const double half = likeness(placed(request));
	request.clumping = 1.0f;
	const double clumped = likeness(placed(request));
	CHECK(apart == doctest::Approx(0.2).epsilon(0.05));
	CHECK(half > 0.3);
	CHECK(half < clumped);
	CHECK(clumped > 0.7);
	CHECK(clumped < 1.0);
	request.drift_size = 0.01f;
	CHECK(likeness(placed(request)) == doctest::Approx(0.2).epsilon(0.05));
}

TEST_CASE("scales, heights, leans, turns and variants fill their ranges evenly") {
	const PlacementRequest request = square_field(100.0f, 10.0f, 1);
	const FieldPlants plants = placed(request);
	double scale = 0.0;
	double height = 0.0;
	double lean = 0.0;
	double turn = 0.0;
	std::array<int, 8> variants = {};
	for (int i = 0; i < plants.size(); i++) {
		const PlacedPlant plant = plants.plant(i);
		CHECK(plant.scale >= 0.8f);
		CHECK(plant.scale <= 1.25f);
		CHECK(std::abs(plant.height - 1.0f) <= 0.3001f);
		CHECK(plant.lean <= 0.2001f);
		scale += static_cast<double>(plant.scale) / plants.size();
		height += static_cast<double>(plant.height) / plants.size();
		lean += static_cast<double>(plant.lean) / plants.size();
		turn += static_cast<double>(plant.turn) / plants.size();
		variants[static_cast<std::size_t>(plant.variant)]++;
	}
	CHECK(scale == doctest::Approx(1.025).epsilon(0.01));
	CHECK(height == doctest::Approx(1.0).epsilon(0.01));
	CHECK(lean == doctest::Approx(0.1).epsilon(0.01));
	CHECK(turn == doctest::Approx(3.1416).epsilon(0.01));
	for (const int count : variants) {
		CHECK(std::abs(count - plants.size() / 8) < 500);
	}
}

TEST_CASE("the positions of an absent species stay empty, and all other plants are unchanged") {
	PlacementRequest request = square_field(20.0f, 5.0f, 3);
	const FieldPlants all = placed(request);
	request.species[1].is_absent = true;
	const FieldPlants some = placed(request);
	CHECK(species_counts(some)[1] == 0);
	std::vector<int> others;
	for (int i = 0; i < all.size(); i++) {
		if (all.species[static_cast<std::size_t>(i)] != 1) {
			others.push_back(i);
		}
	}
	CHECK(others.size() < all.x.size());
	CHECK(some.x == all.reordered(others).x);
}

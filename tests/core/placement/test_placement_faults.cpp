#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>

using namespace undergrowth;

namespace {

const float NOT_A_NUMBER = std::numeric_limits<float>::quiet_NaN();

/// The fault of a sound request with one change. With a fault nothing may be placed.
template <class Change> PlacementFault fault_with(Change change) {
	PlacementRequest request = square_field(10.0f, 2.0f, 2);
	change(request);
	FieldPlants plants;
	plants.resize(3);
	const PlacementFault fault = place_plants(request, plants);
	CHECK(fault == find_placement_fault(request));
	CHECK((plants.size() == 0) == (fault != PlacementFault::none));
	return fault;
}

template <class Change> PlacementFault species_fault_with(Change change) {
	return fault_with([&](PlacementRequest &request) { change(request.species[1]); });
}

} // namespace

TEST_CASE("faults of area and exclusions are found") {
	using Request = PlacementRequest;
	CHECK(fault_with([](Request &) {}) == PlacementFault::none);
	CHECK(fault_with([](Request &r) { r.area = {}; }) == PlacementFault::bad_area);
	CHECK(fault_with([](Request &r) { r.area = rectangle({ 5, 0 }); }) == PlacementFault::bad_area);
	CHECK(fault_with([](Request &r) { r.area[2].x = NOT_A_NUMBER; }) == PlacementFault::bad_area);
	const Polygon broken = { { 0, 0 }, { 1, 0 }, { 1, NOT_A_NUMBER } };
	CHECK(fault_with([&](Request &r) { r.exclusions = { broken }; }) == PlacementFault::bad_exclusion);
	const Polygon far = { { 0, 0 }, { 1, 0 }, { 1, 2.0f * FARTHEST_COORDINATE } };
	CHECK(fault_with([&](Request &r) { r.exclusions = { far }; }) == PlacementFault::bad_exclusion);
	CHECK(fault_with([](Request &r) { r.exclusions = { {}, rectangle({ 1, 0 }) }; }) == PlacementFault::none);
}

TEST_CASE("faults of density, clumping and species are found") {
	using Request = PlacementRequest;
	for (const float density : { -1.0f, 2.0e4f, NOT_A_NUMBER }) {
		CHECK(fault_with([&](Request &r) { r.density = density; }) == PlacementFault::bad_density);
	}
	for (const float clumping : { -0.1f, 1.1f, NOT_A_NUMBER }) {
		CHECK(fault_with([&](Request &r) { r.clumping = clumping; }) == PlacementFault::bad_clumping);
	}
	for (const float combed : { -0.1f, 1.1f, NOT_A_NUMBER }) {
		CHECK(fault_with([&](Request &r) { r.combed = combed; }) == PlacementFault::bad_combed);
	}
	for (const float falloff : { -0.1f, 100.1f, NOT_A_NUMBER }) {
		CHECK(fault_with([&](Request &r) { r.edge_falloff = falloff; }) == PlacementFault::bad_falloff);
	}
	CHECK(fault_with([](Request &r) { r.drift_size = 0.0f; }) == PlacementFault::bad_clumping);
	CHECK(fault_with([](Request &r) { r.species.clear(); }) == PlacementFault::no_species);
	CHECK(fault_with([](Request &r) { r.species.resize(257); }) == PlacementFault::too_many_species);
	CHECK(fault_with([](Request &r) { r.species.resize(256); }) == PlacementFault::none);
	CHECK(fault_with([](Request &r) { r.species[0].weight = r.species[1].weight = 0.0f; }) ==
			PlacementFault::no_weight);
}

TEST_CASE("faults of one species are found") {
	using Species = PlacementSpecies;
	CHECK(species_fault_with([](Species &s) { s.weight = 0.0f; }) == PlacementFault::none);
	CHECK(species_fault_with([](Species &s) { s.weight = -1.0f; }) == PlacementFault::bad_weight);
	CHECK(species_fault_with([](Species &s) { s.weight = NOT_A_NUMBER; }) == PlacementFault::bad_weight);
	CHECK(species_fault_with([](Species &s) { s.weight = std::numeric_limits<float>::infinity(); }) ==
			PlacementFault::bad_weight);
	CHECK(species_fault_with([](Species &s) { s.variants = 0; }) == PlacementFault::bad_variants);
	CHECK(species_fault_with([](Species &s) { s.variants = 257; }) == PlacementFault::bad_variants);
	CHECK(species_fault_with([](Species &s) { s.min_scale = 0.0f; }) == PlacementFault::bad_scale);
	CHECK(species_fault_with([](Species &s) { s.max_scale = 0.5f; }) == PlacementFault::bad_scale);
	CHECK(species_fault_with([](Species &s) { s.max_scale = NOT_A_NUMBER; }) == PlacementFault::bad_scale);
	CHECK(species_fault_with([](Species &s) { s.height_deviation = 1.5f; }) == PlacementFault::bad_deviation);
	CHECK(species_fault_with([](Species &s) { s.max_lean = 1.6f; }) == PlacementFault::bad_deviation);
}

TEST_CASE("a field of too many plants is rejected before any placement") {
	const auto too_many = [](PlacementRequest &r) { r.area = rectangle({ 2001, 2000 }), r.density = 1.0f; };
	CHECK(fault_with(too_many) == PlacementFault::too_many_plants);
	const auto too_long = [](PlacementRequest &r) { r.area = rectangle({ 1.0f, 1.0e5f }), r.density = 1.0e4f; };
	CHECK(fault_with(too_long) == PlacementFault::too_many_plants);
	// Its signed area is 0, but it has many plants.
	const Polygon crossed = { { -1.0e4f, -1.0e4f }, { 1.0e4f, 1.0e4f }, { 1.0e4f, -1.0e4f }, { -1.0e4f, 1.0e4f } };
	const auto bow_tie = [&](PlacementRequest &r) { r.area = crossed, r.density = 1.0f; };
	PlacementRequest request = square_field(10.0f, 1.0f, 1);
	bow_tie(request);
	CHECK(Placement(request).fault() == PlacementFault::too_many_plants);
	CHECK(placed(request).size() == 0);
}

TEST_CASE("the cost of a long thin area depends on its plants, not on its bounding box") {
	PlacementRequest request = square_field(10.0f, 1.0f, 1);
	request.area = { { -5.0e4f, -5.0e4f }, { 5.0e4f, 5.0e4f }, { 5.0e4f, 5.0001e4f }, { -5.0e4f, -4.9999e4f } };
	CHECK(std::abs(placed(request).size() - 100000) < 3000);
}

TEST_CASE("every fault has a sentence") {
	for (int fault = 0; fault <= static_cast<int>(PlacementFault::too_many_plants); fault++) {
		const std::string sentence = describe(static_cast<PlacementFault>(fault));
		REQUIRE(sentence.size() > 10);
		CHECK(sentence.back() == '.');
	}
}

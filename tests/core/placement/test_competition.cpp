#include "placement/competition.hpp"

#include "placement/plant_removal.hpp"
#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

using namespace undergrowth;

namespace {

using Places = std::set<std::pair<float, float>>;

/// A tall species that shades a low one.
Competition tall_and_low(float strength, float radius, float tolerance) {
	Competition competition;
	competition.strength = strength;
	competition.species = { { 3.0f, radius, 1.0f }, { 1.0f, 0.0f, tolerance } };
	competition.seed = 11;
	return competition;
}

Places places_of(const FieldPlants &plants, int species = -1) {
	Places places;
	for (std::size_t i = 0; i < plants.x.size(); i++) {
		if (species < 0 || plants.species[i] == species) {
			places.insert({ plants.x[i], plants.z[i] });
		}
	}
	return places;
}

FieldPlants competed(const Competition &competition, const PlacementRequest &request) {
	PlacementRequest wide = request;
	if (request.within) {
		const float reach = competition.reach();
		wide.within = AreaBox{ request.within->low - reach, request.within->high + reach };
	}
	FieldPlants plants = placed(wide);
	std::vector<float> heights(plants.x.begin(), plants.x.end());
	std::vector<glm::vec3> normals;
	compete(competition, plants, heights, normals);
	if (request.within) {
		crop_plants(*request.within, plants, heights, normals);
	}
	CHECK(heights == plants.x);
	return plants;
}

FieldPlants two_plants(float apart) {
	FieldPlants plants;
	PlacedPlant tall;
	plants.add(tall);
	PlacedPlant low;
	low.species = 1;
	low.root.x = apart;
	plants.add(low);
	return plants;
}

/// Fraction of pairs in which the low plant survives.
double survival(float apart, const Competition &competition) {
	int count = 0;
	constexpr int PAIRS = 4000;
	for (int i = 0; i < PAIRS; i++) {
		FieldPlants plants = two_plants(apart);
		Competition own = competition;
		own.seed = static_cast<uint64_t>(i);
		std::vector<float> heights;
		std::vector<glm::vec3> normals;
		compete(own, plants, heights, normals);
		CHECK(plants.species[0] == 0);
		count += plants.size() == 2 ? 1 : 0;
	}
	return count / static_cast<double>(PAIRS);
}

} // namespace

TEST_CASE("a plant survives the shade of another one by the law of extinction") {
	for (const float apart : { 0.0f, 0.2f, 0.35f }) {
		const double shade = 1.0 - static_cast<double>(apart * apart) / 0.16;
		CHECK(survival(apart, tall_and_low(1.0f, 0.4f, 0.0f)) == doctest::Approx(std::exp(-2.0 * shade)).epsilon(0.08));
		CHECK(survival(apart, tall_and_low(0.5f, 0.4f, 0.25f)) ==
				doctest::Approx(0.25 + 0.75 * std::exp(-shade)).epsilon(0.08));
	}
	CHECK(survival(0.41f, tall_and_low(1.0f, 0.4f, 0.0f)) == 1.0);
	CHECK(survival(0.1f, tall_and_low(0.0f, 0.4f, 0.0f)) == 1.0);
	CHECK(survival(0.1f, tall_and_low(1.0f, 0.4f, 1.0f)) == 1.0);
}

TEST_CASE("the vigorous species displaces the other one, and plants of one species do not compete") {
	const PlacementRequest request = square_field(30.0f, 30.0f, 2);
	const FieldPlants all = placed(request);
	const FieldPlants left = competed(tall_and_low(1.0f, 0.3f, 0.0f), request);
	CHECK(places_of(left, 0) == places_of(all, 0));
	CHECK(places_of(left, 1).size() < 0.5 * places_of(all, 1).size());
	Competition alone;
	alone.strength = 1.0f;
	alone.species = { { 1.0f, 0.5f, 0.0f } };
	const PlacementRequest one = square_field(10.0f, 30.0f, 1);
	CHECK(hash_of(competed(alone, one)) == hash_of(placed(one)));
	const FieldPlants tolerant = competed(tall_and_low(1.0f, 0.3f, 0.8f), request);
	CHECK(places_of(tolerant, 1).size() > 0.8 * places_of(all, 1).size());
	const Places few = places_of(left);
	const Places many = places_of(tolerant);
	CHECK(std::includes(many.begin(), many.end(), few.begin(), few.end()));
}

TEST_CASE("tiles in any order, with their surroundings, have the plants of the whole field") {
	const PlacementRequest request = square_field(30.0f, 30.0f, 3);
	Competition competition;
	competition.strength = 0.8f;
	competition.species = { { 1.0f, 0.35f, 0.1f }, { 1.2f, 0.2f, 0.0f }, { 0.7f, 0.5f, 0.3f } };
	competition.seed = 3;
	const Places whole = places_of(competed(competition, request));
	CHECK(whole.size() < 0.9 * placed(request).size());
	for (const float side : { 7.0f, 2.0f }) {
		Places joined;
		for (int tile = 255; tile >= 0; tile--) {
			PlacementRequest part = request;
			const glm::vec2 low = { -16.0f + side * static_cast<float>(tile % 16),
				-16.0f + side * static_cast<float>(tile / 16) };
			part.within = AreaBox{ low, low + side };
			const Places own = places_of(competed(competition, part));
			joined.insert(own.begin(), own.end());
		}
		CHECK(joined == whole);
	}
}

TEST_CASE("competition without radius or plants changes nothing") {
	const PlacementRequest request = square_field(10.0f, 20.0f, 2);
	CHECK(hash_of(competed(tall_and_low(1.0f, 0.0f, 0.0f), request)) == hash_of(placed(request)));
	CHECK(hash_of(competed(tall_and_low(0.0f, 1.0f, 0.0f), request)) == hash_of(placed(request)));
	CHECK(tall_and_low(0.0f, 1.0f, 0.0f).reach() == 0.0f);
	CHECK(tall_and_low(1.0f, 100.0f, 0.0f).reach() == Competition::MAX_RADIUS);
	FieldPlants none;
	std::vector<float> heights;
	std::vector<glm::vec3> normals;
	compete(tall_and_low(1.0f, 1.0f, 0.0f), none, heights, normals);
	CHECK(none.size() == 0);
}

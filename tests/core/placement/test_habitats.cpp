#include "placement/habitats.hpp"

#include "conventions.hpp"
#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

using namespace undergrowth;

namespace {

constexpr float SIDE = 40.0f; ///< m.
constexpr float NO_HEIGHT = std::numeric_limits<float>::quiet_NaN();

/// A curve through values at even distances.
HabitatCurve curve_of(float low, float high, const std::vector<float> &values) {
	HabitatCurve curve;
	curve.low = low;
	curve.high = high;
	curve.values = values;
	return curve;
}

/// The same habitat for one species of a field.
Habitats habitats_of(const Habitat &habitat, std::size_t species, std::size_t count) {
	Habitats habitats;
	habitats.of_species.resize(count);
	habitats.of_species[species] = std::make_shared<Habitat>(habitat);
	habitats.seed = 5;
	return habitats;
}

std::set<std::pair<float, float>> places_of(const FieldPlants &plants, int species = -1) {
	std::set<std::pair<float, float>> places;
	for (std::size_t i = 0; i < plants.x.size(); i++) {
		if (species < 0 || plants.species[i] == species) {
			places.insert({ plants.x[i], plants.z[i] });
		}
	}
	return places;
}

/// The plants of a field on a ground that rises with x by `rise` (m/m), thinned.
FieldPlants thinned(const Habitats &habitats, const PlacementRequest &request, float rise = 0.0f) {
	FieldPlants plants = placed(request);
	std::vector<float> heights;
	std::vector<glm::vec3> normals;
	for (const float x : plants.x) {
		heights.push_back(rise * x);
		normals.emplace_back(-rise, 1.0f, 0.0f);
	}
	thin_by_habitats(habitats, nullptr, plants, heights, normals);
	CHECK(heights.size() == plants.x.size());
	CHECK(normals.size() == plants.x.size());
	for (std::size_t i = 0; i < plants.x.size(); i++) {
		CHECK(heights[i] == rise * plants.x[i]);
	}
	return plants;
}

Habitat with(HabitatFactor factor, const HabitatCurve &curve) {
	Habitat habitat;
	habitat.curve(factor) = curve;
	return habitat;
}

} // namespace

TEST_CASE("a curve is linear between its values and constant beyond them") {
	const HabitatCurve curve = curve_of(10.0f, 30.0f, { 0.0f, 1.0f, 0.5f });
	CHECK(curve.at(10.0f) == 0.0f);
	CHECK(curve.at(15.0f) == 0.5f);
	CHECK(curve.at(20.0f) == 1.0f);
	CHECK(curve.at(25.0f) == 0.75f);
	CHECK(curve.at(-1.0e30f) == 0.0f);
	CHECK(curve.at(1.0e30f) == 0.5f);
	CHECK(curve.at(NO_HEIGHT) == 0.0f);
	CHECK(HabitatCurve().at(3.0f) == 1.0f);
}

TEST_CASE("a raster is bilinear, and repeats or continues beyond its sides") {
	HabitatRaster raster;
	raster.low = { -2.0f, -1.0f };
	raster.cell = { 2.0f, 1.0f };
	raster.columns = 2;
	raster.rows = 2;
	raster.values = { 0.0f, 1.0f, 2.0f, 3.0f };
	CHECK(raster.at({ -1.0f, -0.5f }) == 0.0f);
	CHECK(raster.at({ 1.0f, 0.5f }) == 3.0f);
	CHECK(raster.at({ 0.0f, 0.0f }) == 1.5f);
	CHECK(raster.at({ 1.0e9f, 1.0e9f }) == 3.0f);
	CHECK(raster.at({ -1.0e9f, -0.5f }) == 0.0f);
	raster.repeats = true;
	CHECK(raster.at({ -1.0f + 4.0f * 100.0f, -0.5f - 2.0f * 7.0f }) == 0.0f);
	CHECK(raster.at({ 1.0f - 4.0f, 0.5f }) == 3.0f);
	CHECK(raster.at({ 2.0f, -0.5f }) == 0.5f); // Between the last and the first column.
	CHECK(HabitatRaster().at({ 3.0f, 4.0f }) == 1.0f);
}

TEST_CASE("suitability is the product of the curves") {
	Habitat habitat = with(HabitatFactor::slope, curve_of(0.0f, 1.0f, { 1.0f, 0.0f }));
	habitat.curve(HabitatFactor::height) = curve_of(0.0f, 100.0f, { 0.0f, 1.0f });
	HabitatPlace place;
	place[HabitatFactor::slope] = 0.25f;
	place[HabitatFactor::height] = 50.0f;
	CHECK(habitat.suitability(place) == doctest::Approx(0.375));
	CHECK(Habitat().suitability(place) == 1.0);
}

TEST_CASE("a habitat thins only its species, to the share of its suitability") {
	const PlacementRequest request = square_field(SIDE, 30.0f, 2);
	const FieldPlants all = placed(request);
	const Habitat half = with(HabitatFactor::height, curve_of(-1.0f, 1.0f, { 0.5f, 0.5f }));
	const FieldPlants left = thinned(habitats_of(half, 1, 2), request);
	CHECK(places_of(left, 0) == places_of(all, 0));
	const auto before = places_of(all, 1);
	const auto after = places_of(left, 1);
	CHECK(std::includes(before.begin(), before.end(), after.begin(), after.end()));
	const double count = static_cast<double>(before.size());
	CHECK(std::abs(static_cast<double>(after.size()) - 0.5 * count) < 4.0 * std::sqrt(0.25 * count));
	CHECK(left.size() < all.size());
}

TEST_CASE("plants follow height and slope of the ground") {
	const PlacementRequest request = square_field(SIDE, 30.0f, 1);
	const Habitat high = with(HabitatFactor::height, curve_of(0.0f, 5.0f, { 0.0f, 1.0f }));
	int low_count = 0;
	int middle_count = 0;
	int high_count = 0;
	for (const float x : thinned(habitats_of(high, 0, 1), request, 0.5f).x) {
		low_count += x <= 0.0f ? 1 : 0;
		middle_count += x > 0.0f && x <= 10.0f ? 1 : 0;
		high_count += x > 10.0f ? 1 : 0;
	}
	CHECK(low_count == 0);
	CHECK(middle_count > 0.45 * high_count);
	CHECK(middle_count < 0.55 * high_count);
	const auto degrees = [](double angle) { return static_cast<float>(angle * PI / 180.0); };
	const Habitat level = with(HabitatFactor::slope, curve_of(degrees(20.0), degrees(40.0), { 1.0f, 0.0f }));
	const auto count_at = [&](double angle) {
		return static_cast<double>(
				thinned(habitats_of(level, 0, 1), request, static_cast<float>(std::tan(angle * PI / 180.0))).size());
	};
	const double all = placed(request).size();
	CHECK(count_at(19.9) == all);
	CHECK(count_at(25.0) == doctest::Approx(0.75 * all).epsilon(0.02));
	CHECK(count_at(40.1) == 0.0);
}

TEST_CASE("a texture gives each position its own suitability") {
	Habitat habitat = with(HabitatFactor::texture, curve_of(0.0f, 1.0f, { 0.0f, 1.0f }));
	habitat.texture.low = { -10.0f, -10.0f };
	habitat.texture.cell = { 10.0f, 20.0f };
	habitat.texture.columns = 2;
	habitat.texture.rows = 1;
	habitat.texture.values = { 0.0f, 1.0f };
	for (const float x : thinned(habitats_of(habitat, 0, 1), square_field(SIDE, 20.0f, 1)).x) {
		CHECK(x > -5.0f);
	}
}

TEST_CASE("plants keep a distance from lines, and areas have the distance 0 inside") {
	HabitatLines lines;
	lines.open = { { { -100.0f, 5.0f }, { 100.0f, 5.0f } } };
	lines.closed = { rectangle({ 4.0f, 4.0f }, { 0.0f, -10.0f }) };
	Habitats habitats = habitats_of(with(HabitatFactor::distance, curve_of(1.0f, 1.01f, { 0.0f, 1.0f })), 0, 1);
	habitats.lines = { std::make_shared<HabitatLines>(lines) };
	const PlacementRequest request = square_field(SIDE, 20.0f, 1);
	const FieldPlants left = thinned(habitats, request);
	int expected = 0;
	for (const auto &[x, z] : places_of(placed(request))) {
		const float aside = std::max(std::abs(x) - 2.0f, std::abs(z + 10.0f) - 2.0f);
		const float dx = std::max(std::abs(x) - 2.0f, 0.0f);
		const float dz = std::max(std::abs(z + 10.0f) - 2.0f, 0.0f);
		const float area = aside <= 0.0f ? 0.0f : std::sqrt(dx * dx + dz * dz);
		expected += std::min(area, std::abs(z - 5.0f)) > 1.005f ? 1 : 0;
	}
	CHECK(std::abs(left.size() - expected) < 0.005 * expected);
	CHECK(HabitatLines().distance_to({ 0.0f, 0.0f }, 7.0f) == 7.0f);
}

TEST_CASE("a survey gives moisture, light and values") {
	const PlacementRequest request = square_field(SIDE, 20.0f, 1);
	HabitatRaster raster;
	raster.low = { -20.0f, -20.0f };
	raster.cell = { 10.0f, 40.0f };
	raster.columns = 4;
	raster.rows = 1;
	raster.values = { 1.0f, 1.0f, 3.0f, 3.0f };
	HabitatSurvey survey;
	survey.moisture = survey.light = raster;
	survey.values = { raster };
	const auto places_with = [&](HabitatFactor factor, const HabitatCurve &curve, const HabitatSurvey *of) {
		FieldPlants plants = placed(request);
		std::vector<float> heights;
		std::vector<glm::vec3> normals;
		thin_by_habitats(habitats_of(with(factor, curve), 0, 1), of, plants, heights, normals);
		return places_of(plants);
	};
	const HabitatCurve second = curve_of(1.0f, 3.0f, { 0.0f, 1.0f, 0.0f });
	for (const HabitatFactor factor : { HabitatFactor::moisture, HabitatFactor::light }) {
		const auto between = places_with(factor, second, &survey);
		CHECK(between.size() > 1000);
		for (const auto &[x, z] : between) {
			CHECK(std::abs(x) < 5.0f); // Between the two values.
		}
	}
	CHECK(places_with(HabitatFactor::value, second, &survey).empty()); // Numbers of kinds have none between them.
	const HabitatCurve third = curve_of(1.0f, 3.0f, { 0.0f, 0.0f, 1.0f });
	const auto left = places_with(HabitatFactor::value, third, &survey);
	CHECK(left.size() > 0.45 * 20.0 * SIDE * SIDE);
	CHECK(left.begin()->first > -5.0f);
	CHECK(places_with(HabitatFactor::value, third, nullptr) == places_of(placed(request)));
}

TEST_CASE("more suitability only adds plants") {
	const PlacementRequest request = square_field(SIDE, 30.0f, 2);
	const auto places_at = [&](float share) {
		const Habitat habitat = with(HabitatFactor::height, curve_of(-1.0f, 1.0f, { share, share }));
		return places_of(thinned(habitats_of(habitat, 0, 2), request));
	};
	auto fewer = places_at(0.0f);
	for (const float share : { 0.1f, 0.5f, 0.9f, 1.0f }) {
		const auto more = places_at(share);
		CHECK(more.size() > fewer.size());
		CHECK(std::includes(more.begin(), more.end(), fewer.begin(), fewer.end()));
		fewer = more;
	}
	CHECK(fewer == places_of(placed(request)));
}

TEST_CASE("tiles have the plants of the whole field") {
	const PlacementRequest request = square_field(SIDE, 30.0f, 2);
	Habitat habitat = with(HabitatFactor::height, curve_of(-5.0f, 5.0f, { 0.0f, 1.0f }));
	habitat.curve(HabitatFactor::distance) = curve_of(0.0f, 6.0f, { 0.0f, 1.0f });
	Habitats habitats = habitats_of(habitat, 0, 2);
	HabitatLines lines;
	lines.open = { { { -15.0f, -20.0f }, { 3.0f, 1.0f }, { 18.0f, 20.0f } } };
	habitats.lines = { std::make_shared<HabitatLines>(lines), nullptr };
	const auto whole = places_of(thinned(habitats, request, 0.3f));
	std::set<std::pair<float, float>> joined;
	for (int tile = 15; tile >= 0; tile--) {
		PlacementRequest part = request;
		const glm::vec2 low = { -20.0f + 10.0f * static_cast<float>(tile % 4),
			-20.0f + 10.0f * static_cast<float>(tile / 4) };
		part.within = AreaBox{ low, low + 10.0f };
		const auto own = places_of(thinned(habitats, part, 0.3f));
		joined.insert(own.begin(), own.end());
	}
	CHECK(joined == whole);
}

TEST_CASE("plants without ground and fields without habitats stay as they are") {
	const FieldPlants all = placed(square_field(SIDE, 10.0f, 1));
	FieldPlants plants = all;
	std::vector<float> heights(plants.x.size(), NO_HEIGHT);
	std::vector<glm::vec3> normals(plants.x.size(), { 0.0f, 1.0f, 0.0f });
	const Habitat nowhere = with(HabitatFactor::height, curve_of(0.0f, 1.0f, { 0.0f, 0.0f }));
	thin_by_habitats(habitats_of(nowhere, 0, 1), nullptr, plants, heights, normals);
	CHECK(hash_of(plants) == hash_of(all)); // apply_ground() removes them.
	thin_by_habitats(Habitats(), nullptr, plants, heights, normals);
	CHECK(hash_of(plants) == hash_of(all));
	std::vector<float> none;
	std::vector<glm::vec3> no_normals;
	thin_by_habitats(habitats_of(nowhere, 0, 1), nullptr, plants, none, no_normals);
	CHECK(plants.size() == 0);
}

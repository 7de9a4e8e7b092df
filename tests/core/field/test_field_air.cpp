#include "../motion/varied.hpp"
#include "../wind/air_series.hpp"

#include "field/field_simulation.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>

using namespace undergrowth;

namespace {

FieldWind fresh_breeze() {
	FieldWind wind;
	wind.wind.kind = WindKind::air;
	wind.air.speed = 9.0f;
	wind.speed = static_cast<float>(turbulence_speed(wind.air));
	wind.tiles = std::shared_ptr<const AirTiles>(&shared_tiles(), [](const AirTiles *) {});
	return wind;
}

/// Two pages, 500 m apart.
FieldSimulation two_pages(int prototypes) {
	FieldSettings settings;
	settings.prototypes = prototypes;
	FieldSimulation field(settings);
	MotionSpecies species = species_with(Law::spring, varied_joint(1));
	species.canopy_height = 0.7f;
	const int kind = field.add_species(species);
	for (const float place : { 0.0f, 500.0f }) {
		std::vector<MotionPlant> plants;
		for (int i = 0; i < 200; i++) {
			plants.push_back(varied_plant(i));
			plants.back().root.x += place;
		}
		field.add_page(kind, plants.data(), static_cast<int>(plants.size()));
	}
	field.set_wind(fresh_breeze());
	return field;
}

} // namespace

TEST_CASE("in air each plant of a field has its own motion, and so does each follower") {
	for (const int prototypes : { 0, 16 }) {
		FieldSimulation field = two_pages(prototypes);
		glm::vec3 before = {};
		float farthest = 0.0f, apart = 0.0f;
		for (int i = 0; i < 300; i++) {
			field.step();
			const glm::vec3 now = field.shown_direction(0, 3, 1.0f);
			farthest = std::max(farthest, i > 60 ? glm::distance(now, before) : 0.0f);
			apart = std::max(apart, glm::distance(now, field.shown_direction(1, 3, 1.0f)));
			before = now;
		}
		CHECK(farthest > 1e-4f);
		CHECK(farthest < 0.3f);
		CHECK(apart > 0.01f);
	}
}

TEST_CASE("a source that stirs the air at one end of a field has no effect at the other") {
	FieldSimulation calm = two_pages(0), stirred = two_pages(0);
	AirSource fan;
	fan.kind = AirSource::Kind::fan;
	fan.speed = 6.0f;
	stirred.set_air_sources({ fan });
	for (int i = 0; i < 120; i++) {
		calm.step();
		stirred.step();
	}
	CHECK(glm::distance(calm.shown_direction(0, 3, 1.0f), stirred.shown_direction(0, 3, 1.0f)) > 0.01f);
	for (int i = 0; i < 200; i++) {
		REQUIRE(same_bits(calm.state(1, i), stirred.state(1, i)));
	}
}

/// Distance of tips from those of plants that sample their air in each step, over the size of their motion (both as
/// root mean square).
static double error_of_sampling_ahead(Law law, float frequency) {
	constexpr int STEPS = 1200;
	constexpr int SETTLED = 300;
	FieldSimulation field = FieldSimulation(FieldSettings());
	Joint joint = varied_joint(1);
	joint.natural_frequency = frequency;
	const float rate = static_cast<float>(2.0 * PI) * frequency;
	joint.elasticity = rate * rate / STANDARD_GRAVITY; // For a plant of 1 m.
	MotionSpecies species = species_with(law, joint);
	species.canopy_height = 0.7f;
	std::vector<MotionPlant> plants;
	for (int i = 0; i < 64; i++) {
		plants.push_back(varied_plant(i));
	}
	field.add_page(field.add_species(species), plants.data(), static_cast<int>(plants.size()));
	const FieldWind wind = fresh_breeze();
	field.set_wind(wind);
	MotionPage page(0, species, plants.data(), static_cast<int>(plants.size()), field.settings().step, true);
	double errors = 0.0, squares = 0.0;
	glm::dvec3 sum(0.0);
	for (int step = 0; step < STEPS; step++) {
		field.step();
		const double moment = (step + page.wind_moment()) * static_cast<double>(page.step_length());
		page.step(wind_at_time(wind, moment), winds_along(wind));
		for (int i = 0; i < page.size() && step >= SETTLED; i++) {
			const glm::dvec3 is = page.direction(i) - page.rest(i);
			const glm::dvec3 off = glm::dvec3(field.page(0).direction(i) - page.rest(i)) - is;
			errors += glm::dot(off, off);
			squares += glm::dot(is, is);
			sum += is;
		}
	}
	const double count = static_cast<double>(page.size()) * (STEPS - SETTLED);
	return std::sqrt(errors / (squares - glm::dot(sum, sum) / count));
}

TEST_CASE("tips in air that is sampled ahead move like tips that sample it in each step") {
	constexpr double WITHIN = 0.08; // Fraction of their motion.
	for (const float frequency : { 0.7f, 1.5f, 3.0f }) {
		CHECK(error_of_sampling_ahead(Law::spring, frequency) < WITHIN);
		CHECK(error_of_sampling_ahead(Law::elasticity, frequency) < WITHIN);
	}
}

TEST_CASE("plants that are moved have the wind of their new position") {
	MotionSpecies species = species_with(Law::spring, varied_joint(1));
	species.canopy_height = 0.7f;
	const FieldWind wind = fresh_breeze();
	const PlantWinds along = winds_along(wind);
	MotionPlant plant = varied_plant(1);
	MotionPage moved(0, species, &plant, 1, 1.0f / 60.0f, true);
	moved.make_room_ahead();
	const auto step = [&](MotionPage &page, int number) {
		const double moment = (number + page.wind_moment()) / 60.0;
		page.sample_air_ahead(wind, along, moment, 0);
		page.step(wind_at_time(wind, moment), along);
	};
	for (int i = 0; i < 10; i++) {
		step(moved, i);
	}
	const TipState before = moved.state(0);
	plant.root.x += 300.0f;
	moved.set_plant(0, plant);
	MotionPage there(0, species, &plant, 1, 1.0f / 60.0f, true);
	there.make_room_ahead();
	moved.set_state(0, before);
	there.set_state(0, before);
	step(moved, 10);
	step(there, 10);
	CHECK(same_bits(moved.state(0), there.state(0)));
}

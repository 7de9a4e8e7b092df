#include "../wind/air_series.hpp"
#include "varied.hpp"

#include "motion/part_air.hpp"
#include "motion/part_bend.hpp"
#include "wind/air_profile.hpp"
#include "wind/field_wind.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>

using namespace undergrowth;

namespace {

FieldWind smooth_air(float speed) {
	FieldWind wind;
	wind.wind.kind = WindKind::air;
	wind.air.speed = speed;
	wind.air.turbulence = 0.0f;
	wind.tiles = std::shared_ptr<const AirTiles>(&shared_tiles(), [](const AirTiles *) {});
	return wind;
}

float speed_over(float speed, float canopy_height, const TallerPlants &taller = {}) {
	const FieldWind wind = smooth_air(speed);
	MotionSpecies species = species_with(Law::spring, varied_joint(1));
	species.canopy_height = canopy_height;
	return air_speed_at(wind_at_time(wind, 5.0), winds_along(wind), species, taller, 0.5f, { 3.0f, 0.0f, 2.0f });
}

} // namespace

TEST_CASE("the air at a plant is that of its canopy, of open ground, or within taller plants") {
	CHECK(speed_over(8.0f, 0.6f) == doctest::Approx(8.0 * canopy_top_speed(0.6)).epsilon(1e-4));
	CHECK(speed_over(8.0f, 0.0f) == doctest::Approx(8.0 * open_ground_speed(0.5, 0.03)).epsilon(1e-4));
	CHECK(speed_over(8.0f, 0.2f, { 0.9f, 1.0f }) == doctest::Approx(8.0 * canopy_speed(0.2, 0.9)).epsilon(1e-4));
	CHECK(speed_over(0.0f, 0.6f) == 0.0f);
}

TEST_CASE("the air below a few taller plants is between that of its own canopy and that within theirs") {
	const double open = 8.0 * canopy_top_speed(0.2);
	const double within = 8.0 * canopy_speed(0.2, 0.9);
	for (const float cover : { 0.0f, 0.25f, 0.75f }) {
		const double share = static_cast<double>(cover);
		const double wanted = (1.0 - share) * open + share * within;
		CHECK(speed_over(8.0f, 0.2f, { 0.9f, cover }) == doctest::Approx(wanted).epsilon(1e-4));
	}
}

TEST_CASE("light air moves light leaves of sheltered plants, and still air moves none") {
	PartMotion leaf;
	leaf.side = { 1.0f, 0.0f };
	leaf.frequency = 1.5f;
	const auto flutter_in = [&](float speed) {
		float furthest = 0.0f;
		for (int i = 0; i < 500; i++) {
			StemMotion stem;
			stem.air = speed_over(speed, 0.2f, { 0.9f, 1.0f });
			stem.clock = static_cast<float>(i) / 500.0f;
			furthest = std::max(furthest, glm::length(part_bend(leaf, stem)));
		}
		return furthest;
	};
	CHECK(flutter_in(0.0f) == 0.0f);
	CHECK(flutter_in(0.3f) > 0.01f); // A degree.
	CHECK(flutter_in(1.5f) > 0.01f);
	CHECK(speed_over(3.5f, 0.2f, { 0.9f, 1.0f }) < 0.15f);
}

TEST_CASE("a wind in newtons counts as the air with the same force") {
	FieldWind wind;
	wind.wind.kind = WindKind::constant;
	wind.wind.strength = 1.5f;
	MotionSpecies species = species_with(Law::spring, varied_joint(1));
	species.joint.drag_area = 0.4f;
	species.joint.wind_weight = 1.0f;
	const float speed =
			air_speed_at(wind_at_time(wind, 5.0), winds_along(wind), species, {}, 0.5f, { 3.0f, 0.0f, 2.0f });
	CHECK(0.5 * static_cast<double>(AIR_DENSITY) * 0.4 * static_cast<double>(speed * speed) ==
			doctest::Approx(1.5).epsilon(1e-3));
}

TEST_CASE("leaves are still four seconds after a gale, and their flutter is faster in it") {
	PartAir gale, breeze;
	PartMotion leaf;
	leaf.side = { 1.0f, 0.0f };
	for (int i = 0; i < 600; i++) {
		gale.step(4.0f, 1.0 / 60.0);
		breeze.step(1.0f, 1.0 / 60.0);
	}
	CHECK(gale.speed() == doctest::Approx(4.0).epsilon(0.01));
	const float before = gale.turns();
	const float before_in_breeze = breeze.turns();
	for (int i = 0; i < 60; i++) {
		gale.step(4.0f, 1.0 / 60.0);
		breeze.step(1.0f, 1.0 / 60.0);
	}
	const auto turned_by = [](float from, float to) { return to - from - std::floor(to - from); };
	CHECK(turned_by(before, gale.turns()) > turned_by(before_in_breeze, breeze.turns()) + 0.1f);
	for (int i = 0; i < 240; i++) {
		gale.step(0.0f, 1.0 / 60.0);
	}
	StemMotion stem;
	stem.air = gale.speed();
	stem.turns = gale.turns();
	CHECK(part_bend(leaf, stem) == glm::vec2(0.0f));
}

#include "field_fixture.hpp"

#include "field/mean_lean.hpp"

#include <doctest/doctest.h>

using namespace undergrowth;

namespace {

/// Mean lean of both species after `seconds` of a wind of this strength.
std::vector<float> leans_in(float strength, int seconds) {
	FieldSimulation field = mixed_field({}, 600, 64);
	FieldWind wind = wave_wind();
	wind.wind.strength = strength;
	field.set_wind(wind);
	MeanLean leans;
	for (int i = 0; i < 60 * seconds; i++) {
		field.step();
		leans.follow(field);
	}
	return { leans.of(0), leans.of(1) };
}

} // namespace

TEST_CASE("the mean lean is 0 in calm air and grows with the wind") {
	CHECK(MeanLean().of(0) == 0.0f);
	const std::vector<float> calm = leans_in(0.0f, 1);
	const std::vector<float> weak = leans_in(0.5f, 20);
	const std::vector<float> strong = leans_in(2.0f, 20);
	for (size_t i = 0; i < calm.size(); i++) {
		CHECK(calm[i] < 1e-3f);
		CHECK(weak[i] > 0.01f);
		CHECK(strong[i] > 1.3f * weak[i]);
		CHECK(strong[i] < 1.0f);
	}
}

TEST_CASE("the mean lean forgets an earlier wind") {
	FieldSimulation field = mixed_field({}, 600, 64);
	MeanLean leans;
	FieldWind wind = wave_wind();
	const auto apply_wind = [&](float strength, int seconds) {
		wind.wind.strength = strength;
		field.set_wind(wind);
		for (int i = 0; i < 60 * seconds; i++) {
			field.step();
			leans.follow(field);
		}
		return leans.of(1);
	};
	const float windy = apply_wind(2.0f, 20);
	const float soon = apply_wind(0.0f, 4);
	const float later = apply_wind(0.0f, 30);
	CHECK(soon < windy);
	CHECK(soon > 0.3f * windy);
	CHECK(later < 0.1f * windy);
}

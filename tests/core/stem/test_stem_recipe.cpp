#include "stems.hpp"

#include "stem/stem_recipe.hpp"
#include "stem/stem_shape.hpp"

#include <doctest/doctest.h>

using namespace undergrowth;
using doctest::Approx;

namespace {

/// rad, tip angle in 1 N, over the tip angle of a mass of 1 kg: about 1 for usual weights.
float usual_lean(const StemConstants &stem) {
	const float frequency = stem.mode[0].frequency;
	return stem.dead_slope * frequency * frequency * stem.length;
}

} // namespace

TEST_CASE("a recipe with a weight is the stem itself, in newtons and in air") {
	StemRecipe recipe;
	recipe.beam = stem_of(0.5, 1.0);
	recipe.wind_weight = 0.25f;
	const SolvedStem solved = solve_recipe(recipe);
	StemConstants stem = solve_stem(recipe.beam).constants;
	CHECK(solved.fault == StemFault::none);
	stem.dead_slope *= 0.25f;
	CHECK(*solved.in_newtons == stem);
	CHECK(*solved.in_air == in_air(stem));
	CHECK(solved.usual_weight == 0.0f);
}

TEST_CASE("with the usual weight one newton acts on all stems as on a kilogram") {
	for (const double frequency : { 0.7, 3.0 }) {
		StemRecipe recipe;
		recipe.beam = stem_of(0.3, 0.5, frequency);
		recipe.own_length = recipe.beam.length;
		CHECK(usual_lean(*solve_recipe(recipe).in_newtons) == Approx(1.0).epsilon(1e-5));
	}
}

TEST_CASE("stems of other heights have the usual weight of the species' own height") {
	StemRecipe own;
	own.beam = stem_of(0.5, 0.0, 0.0);
	own.own_length = own.beam.length;
	const float weight = solve_recipe(own).usual_weight;
	StemRecipe taller = own;
	taller.beam.length *= 1.331f;
	CHECK(solve_recipe(taller).usual_weight == weight);
	taller.usual_weight = weight;
	const SolvedStem found = solve_recipe(taller);
	CHECK(found.usual_weight == weight);
	CHECK(found.in_newtons->dead_slope == Approx(weight * solve_stem(taller.beam).constants.dead_slope));
}

TEST_CASE("less wind on joints also means less wind with the usual weight") {
	StemRecipe recipe;
	recipe.beam = stem_of();
	recipe.own_length = recipe.beam.length;
	const auto lean_at = [&](float weight) {
		recipe.beam.wind_weights.assign(static_cast<std::size_t>(recipe.beam.joints), weight);
		return usual_lean(*solve_recipe(recipe).in_newtons);
	};
	CHECK(lean_at(0.5f) == Approx(0.5 * lean_at(1.0f)).epsilon(1e-5));
	CHECK(lean_at(1.0f) > 0.5f);
}

TEST_CASE("an unstable stem is replaced by a bare one with the same joints") {
	StemRecipe recipe;
	recipe.beam = stem_of(0.5, 2.0, 0.0);
	recipe.beam.youngs_modulus = 1e4f;
	recipe.beam.joints = 7;
	const SolvedStem solved = solve_recipe(recipe);
	CHECK(solved.fault == StemFault::falls);
	CHECK(solved.in_newtons->joints == 7);
	CHECK(solved.in_newtons->length == recipe.beam.length);
	CHECK(solved.in_newtons->mode[0].frequency == Approx(2.0 * PI * 1.5).epsilon(0.01));
}

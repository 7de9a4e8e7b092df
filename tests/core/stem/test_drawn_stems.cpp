#include "mesh/form_stem.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace undergrowth;

TEST_CASE("the drawn lathe of any size is a sound stem") {
	const std::vector<std::vector<float>> profiles = { { 1.0f }, { 1.0f, 1.0f, 1.0f }, { 0.0f, 0.0f, 0.0f, 0.0f },
		{ 0.1f, 0.1f, 0.1f, 50.0f, 1.0f }, { 1.0f, 0.5f, 0.2f, 0.0f } };
	for (const float length : { 0.005f, 0.6f, 100.0f }) {
		for (const float radius : { 1e-6f, 0.004f, 1.0f, 1e3f }) {
			for (const std::vector<float> &widths : profiles) {
				StemBeam beam;
				beam.length = length;
				carry_lathe(radius, widths, beam);
				CAPTURE(length);
				CAPTURE(radius);
				CHECK(find_fault(beam) == StemFault::none);
				CHECK(solve_stem(beam).fault == StemFault::none);
			}
		}
	}
}

TEST_CASE("rings much wider than a lathe's lower half are its head") {
	StemBeam stalk, flower;
	stalk.length = flower.length = 0.5f;
	carry_lathe(0.01f, { 0.4f, 0.4f, 0.4f, 0.4f, 0.4f, 0.2f }, stalk);
	carry_lathe(0.01f, { 0.4f, 0.4f, 0.4f, 0.4f, 3.0f, 1.0f }, flower);
	CHECK(stalk.diameter == doctest::Approx(0.008));
	CHECK(stalk.taper == doctest::Approx(0.5));
	CHECK(stalk.head_mass == 0.0f);
	CHECK(flower.diameter == doctest::Approx(0.008));
	CHECK(flower.head_mass > 0.0f);
	CHECK(flower.head_drag_area > 0.0f);
}

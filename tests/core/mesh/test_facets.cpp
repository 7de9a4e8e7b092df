#include "../form/form_species.hpp"
#include "mesh/facets.hpp"
#include "mesh/form_measure.hpp"

#include <doctest/doctest.h>

using namespace undergrowth;

namespace {

// Of one upright blade, drawn with this number of rows.
float facets_of_blade(const Part &part, int rows) {
	const PlantForm form = grow_alone(part);
	FormPlan plan = plan_form(form, measure_form(form), 1000000);
	plan.groups[0].detail = { 3, rows };
	return facets_of(form, plan);
}

} // namespace

TEST_CASE("broad leaves of few rows have visible edges, and even or narrow ones have none") {
	Part leaf;
	leaf.length_min = leaf.length_max = 0.15f;
	leaf.width = 0.06f;
	leaf.widths.profile = ELLIPTIC_PROFILE;
	const float coarse = facets_of_blade(leaf, 2);
	CHECK(coarse > 0.004f);
	CHECK(coarse < 0.012f);
	CHECK(facets_of_blade(leaf, 4) < coarse);
	CHECK(facets_of_blade(leaf, 18) < 0.5f * coarse);
	Part blade = leaf;
	blade.width = 0.003f;
	CHECK(facets_of_blade(blade, 2) == doctest::Approx(0.05f * coarse));
	Part even = leaf;
	even.widths.profile = EVEN_PROFILE;
	CHECK(facets_of_blade(even, 2) == doctest::Approx(0.0f));
}

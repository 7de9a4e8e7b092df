#include "form/growth.hpp"
#include "form_mesh_fixture.hpp"

#include <doctest/doctest.h>

using namespace undergrowth;

namespace {

/// Long leaves that bend much or little, each in its own way.
PlantForm grow_wanderers(uint64_t seed) {
	Growth growth(0.3f, seed);
	Part leaf;
	leaf.length_min = leaf.length_max = 0.3f;
	leaf.width = 0.02f;
	leaf.curve.bend = 0.8f;
	leaf.curve.wander = 0.8f;
	Arrangement tuft;
	tuft.layout = Layout::ground;
	tuft.count_min = tuft.count_max = 3;
	tuft.radius = 0.1f;
	int kind = 0;
	std::vector<int> made;
	REQUIRE(growth.add_kind(leaf, kind) == "");
	REQUIRE(growth.arrange(kind, tuft, { ON_GROUND }, made) == "");
	return growth.finish();
}

} // namespace

TEST_CASE("a plant is measured with the own curve of each of its parts") {
	for (uint64_t seed = 1; seed <= 8; seed++) {
		const PlantForm form = grow_wanderers(seed);
		const FormMeasure measure = measure_form(form);
		const BuiltForm mesh = build(form, plan_form(form, measure, 1000000));
		const Outlines drawn = outline_areas(
				{ mesh.positions.data(), mesh.size(), mesh.indices.data(), static_cast<int>(mesh.indices.size()) },
				measure.box);
		for (size_t side = 0; side < OUTLINES; side++) {
			INFO("seed " << seed << ", side " << side);
			CHECK(drawn[side] / measure.outlines[side] == doctest::Approx(1.0).epsilon(0.005));
		}
	}
}

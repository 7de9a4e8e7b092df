#include "form_mesh_fixture.hpp"

#include "../base/sanitized.hpp"
#include "../form/any_species.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace undergrowth;

namespace {

constexpr uint64_t SPECIES = repetitions(60, 15); // `./run test suites=species` grows any number of them.

bool is_finite(const BuiltForm &mesh) {
	bool finite = true;
	for (size_t i = 0; i < mesh.positions.size(); i++) {
		finite = finite && std::isfinite(glm::dot(mesh.positions[i], mesh.positions[i])) &&
				std::abs(glm::length(mesh.normals[i]) - 1.0f) < 1e-4f &&
				std::abs(glm::length(glm::vec3(mesh.tangents[i])) - 1.0f) < 1e-4f &&
				std::isfinite(mesh.colors[i].x + mesh.colors[i].w + mesh.custom0[i].x + mesh.custom1[i].x +
						mesh.custom2[i].x);
	}
	return finite;
}

} // namespace

TEST_CASE("species of any numbers within their limits are finite and within their budgets") {
	int grown = 0;
	for (uint64_t seed = 0; seed < SPECIES; seed++) {
		Chance chance(seed);
		const Recipe recipe = any_recipe(chance);
		Growth growth(1.0f, seed);
		if (!grow(recipe, ON_GROUND, growth).empty()) {
			continue; // Too deep or too many.
		}
		grown++;
		const PlantForm form = growth.finish();
		const FormMeasure measure = measure_form(form);
		for (const int lod : { 24, 12, 3, 1 }) {
			const FormPlan plan = plan_form(form, measure, vertex_budget(lod));
			const BuiltForm mesh = build(form, plan);
			INFO("seed " << seed << ", " << lod << " segments");
			CHECK(mesh.size() <= vertex_budget(lod));
			CHECK(mesh.size() > 0);
			CHECK(is_finite(mesh));
			CHECK(std::all_of(mesh.indices.begin(), mesh.indices.end(),
					[&](int32_t index) { return index >= 0 && index < mesh.size(); }));
		}
	}
	CHECK(grown > static_cast<int>(SPECIES / 3));
}

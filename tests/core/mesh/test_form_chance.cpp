#include "form/growth.hpp"
#include "form_mesh_fixture.hpp"

#include "base/random.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace undergrowth;

namespace {

#ifdef UNDERGROWTH_MANY
constexpr uint64_t SPECIES = UNDERGROWTH_MANY;
#else
constexpr uint64_t SPECIES = 60;
#endif

/// Odd numbers within what parts allow.
class Chance {
public:
	explicit Chance(uint64_t p_seed) : seed(p_seed) {}

	float within(float least, float most) {
		const float share = 0.5f + 0.5f * signed_noise(seed, index++);
		return one_in(6) ? (one_in(2) ? least : most) : least + (most - least) * share; // Borders often.
	}
	/// The same over powers of ten.
	float spread(float least, float most) {
		const float share = 0.5f + 0.5f * signed_noise(seed, index++);
		return std::min(std::max(least * std::pow(most / least, share), least), most);
	}
	int whole(int least, int most) {
		return least + static_cast<int>(mix_bits(mix_bits(seed) ^ index++) % static_cast<uint64_t>(most - least + 1));
	}
	bool one_in(int many) { return whole(1, many) == 1; }

private:
	uint64_t seed;
	uint64_t index = 0;
};

Part any_part(Chance &chance) {
	Part part;
	part.kind = static_cast<PartKind>(chance.whole(0, 2));
	part.length_min = chance.spread(1e-4f, 50.0f);
	part.length_max = part.length_min * chance.spread(1.0f, 2.0f);
	part.width = chance.spread(1e-5f, 5.0f);
	part.widths.profile = { chance.within(0.0f, 8.0f), chance.within(0.0f, 8.0f) };
	part.widths.base_width = chance.within(0.0f, 1.0f);
	part.curve = { chance.within(-12.0f, 12.0f), chance.within(0.5f, 4.0f),
		chance.one_in(3) ? chance.within(0.0f, 1.5f) : 0.0f };
	part.axis.tip_diameter = chance.one_in(4) ? 0.0f : chance.spread(1e-5f, 5.0f);
	part.axis.open_tip = chance.one_in(4);
	part.axis.lobes = chance.one_in(4) ? chance.whole(0, 64) : 0;
	part.axis.lobe_depth = chance.within(0.0f, 0.9f);
	part.blade.fold = chance.within(-1.5f, 1.5f);
	part.blade.roll = chance.within(-6.0f, 6.0f);
	part.blade.twist = chance.within(-20.0f, 20.0f);
	part.blade.wave = chance.within(0.0f, 1.0f);
	part.blade.teeth = chance.one_in(4) ? chance.whole(1, 32) : 0;
	part.blade.tooth_depth = chance.within(0.0f, 0.9f);
	return part;
}

Arrangement any_arrangement(Chance &chance) {
	Arrangement a;
	a.layout = static_cast<Layout>(chance.whole(0, 3));
	a.count_min = chance.one_in(8) ? chance.whole(20, 200) : chance.whole(1, 8);
	a.count_max = a.count_min + chance.whole(0, 4);
	a.from = chance.within(0.0f, 1.0f);
	a.to = chance.within(0.0f, 1.0f);
	a.per_node = chance.whole(1, 5);
	a.turn = chance.within(-7.0f, 7.0f);
	a.angle = { chance.within(-4.0f, 4.0f), chance.within(-4.0f, 4.0f) };
	a.scale = { chance.spread(1e-3f, 10.0f), chance.spread(1e-3f, 10.0f) };
	a.radius = chance.one_in(3) ? 0.0f : chance.spread(1e-4f, 3.0f);
	a.dome = chance.within(0.0f, 3.14f);
	a.level_tops = chance.one_in(3);
	a.tilt = { chance.within(-3.0f, 3.0f), chance.within(-3.0f, 3.0f) };
	a.deviation = chance.within(0.0f, 1.5f);
	return a;
}

Recipe any_recipe(uint64_t seed) {
	Chance chance(seed);
	Recipe recipe;
	const int kinds = chance.whole(1, 5);
	for (int i = 0; i < kinds; i++) {
		recipe.kinds.push_back(any_part(chance));
	}
	const int lines = chance.whole(1, 6);
	for (int i = 0; i < lines; i++) {
		recipe.lines.push_back({ chance.whole(0, kinds - 1), any_arrangement(chance), chance.whole(-1, i - 1) });
	}
	return recipe;
}

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
		const Recipe recipe = any_recipe(seed);
		Growth growth(1.0f, seed);
		if (!grow(recipe, ON_GROUND, growth).empty()) {
			continue; // Too deep or too many.
		}
		grown++;
		const PlantForm form = growth.finish();
		const FormMeasure measure = measure_form(form);
		for (const int lod : { 12, 3, 1 }) {
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

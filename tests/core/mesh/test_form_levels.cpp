#include "../form/form_species.hpp"
#include "form_mesh_fixture.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace undergrowth;

// What a level may change of the silhouette from eight sides, as the mean over them and at the worst of them, and of
// the mean colour (ΔE). Near levels are as good as alike; 12 vertices have no room for all sides and colours of a
// flower.

namespace {

using Grow = PlantForm (*)(uint64_t);
constexpr Grow SPECIES[] = { grow_grass, grow_tulip, grow_daisy };
constexpr int SIDES = 8;

struct Tolerance {
	int lod;
	double mean_area;
	double side_area;
	double color;
};

constexpr Tolerance TOLERANCES[] = { { 12, 0.05, 0.1, 3.0 }, { 6, 0.05, 0.15, 3.0 }, { 3, 0.05, 0.25, 5.0 },
	{ 2, 0.08, 0.6, 5.0 }, { 1, 0.2, 1.0, 15.0 } };

struct Sights {
	Sight sides[SIDES];
	double area = 0.0;
	glm::dvec3 light = glm::dvec3(0.0);
};

Sights look_around(const PlantForm &form, int budget) {
	const BuiltForm mesh = build(form, plan_form(form, measure_form(form), budget));
	Sights sights;
	for (int side = 0; side < SIDES; side++) {
		sights.sides[side] = look_at(mesh, side, 1.4 * form.height);
		sights.area += sights.sides[side].area;
		sights.light += sights.sides[side].light * sights.sides[side].area;
	}
	sights.light /= sights.area;
	return sights;
}

} // namespace

TEST_CASE("levels keep the silhouette and the mean colour of all parts") {
	for (const Grow grow : SPECIES) {
		for (const uint64_t seed : { 2, 4 }) {
			const PlantForm form = grow(seed);
			const Sights fine = look_around(form, 1000000);
			for (const Tolerance &most : TOLERANCES) {
				const Sights level = look_around(form, vertex_budget(most.lod));
				INFO(form.placed.size() << " parts, seed " << seed << ", " << most.lod << " segments");
				CHECK(std::abs(level.area / fine.area - 1.0) < most.mean_area);
				CHECK(color_distance(level.light, fine.light) < most.color);
				for (int side = 0; side < SIDES; side++) {
					CHECK(std::abs(level.sides[side].area / fine.sides[side].area - 1.0) < most.side_area);
				}
			}
		}
	}
}

TEST_CASE("every level shows the same plant: what it draws stands where it grew") {
	for (const Grow grow : SPECIES) {
		const PlantForm form = grow(3);
		const FormMeasure measure = measure_form(form);
		for (const int lod : { 12, 6, 3, 2, 1 }) {
			const FormPlan plan = plan_form(form, measure, vertex_budget(lod));
			const BuiltForm mesh = build(form, plan);
			int first = 0;
			for (size_t i = 0; i < form.placed.size(); i++) {
				if (plan.fates[i] != FormPlan::drawn) {
					continue;
				}
				const PlacedPart &part = form.placed[i];
				const Part &kind = form.parts[static_cast<size_t>(part.kind)];
				// The first vertex of a part lies across its base, beads' within them.
				const size_t vertex = static_cast<size_t>(first);
				const glm::vec3 middle = mesh.positions[vertex] - glm::vec3(mesh.custom2[vertex]);
				CHECK(glm::length(middle - part.base) <= (kind.kind == PartKind::bead ? part.length : 1e-5f));
				first += count_part(kind, plan.groups[static_cast<size_t>(part.group)].detail).vertices;
			}
		}
	}
}

TEST_CASE("plans drop what is small first: florets before leaves, leaves before the stem") {
	const PlantForm form = grow_daisy(1);
	const FormMeasure measure = measure_form(form);
	const FormPlan plan = plan_form(form, measure, vertex_budget(6));
	CHECK(plan.groups[3].body.sides > 0); // The disc is a dome.
	CHECK(plan.groups[1].kept == 1.0f);
	CHECK(plan.groups[1].detail.columns > 2); // The stem is round.
	const FormPlan far = plan_form(form, measure, vertex_budget(1));
	CHECK(far.counts.vertices > 0);
	CHECK(far.fates[static_cast<size_t>(form.groups[1].first)] == FormPlan::drawn);
}

TEST_CASE("a plan within its budget draws all parts as finely as they are") {
	const PlantForm form = grow_tulip(1);
	const FormPlan plan = plan_form(form, measure_form(form), 100000);
	CHECK(!plan.is_cut);
	CHECK(std::all_of(
			plan.fates.begin(), plan.fates.end(), [](FormPlan::Fate fate) { return fate == FormPlan::drawn; }));
}

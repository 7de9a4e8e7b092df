// Plants that tests with random species have found (tests/species).

#include "../base/sanitized.hpp"
#include "form_mesh_fixture.hpp"

#include "form/growth.hpp"
#include "mesh/plan_steps.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace undergrowth;

namespace {

Part axis(float length, float width, float bend = 0.0f) {
	Part part;
	part.kind = PartKind::axis;
	part.length_min = part.length_max = length;
	part.width = width;
	part.curve.bend = bend;
	return part;
}

std::vector<int> add(Growth &growth, const Part &part, int count, Layout layout, const std::vector<int> &carriers) {
	int kind = 0;
	std::vector<int> handles;
	Arrangement arrangement;
	arrangement.layout = layout;
	arrangement.count_min = arrangement.count_max = count;
	CHECK(growth.add_kind(part, kind) == "");
	CHECK(growth.arrange(kind, arrangement, carriers, handles) == "");
	return handles;
}

} // namespace

TEST_CASE("a plant with leaves on stems of two kinds is visible at all levels") {
	Growth growth(1.0f, 1);
	const std::vector<int> thin = add(growth, axis(0.01f, 1e-4f), 1, Layout::ground, { ON_GROUND });
	const std::vector<int> thick = add(growth, axis(0.02f, 1e-4f), 1, Layout::ground, { ON_GROUND });
	add(growth, axis(0.5f, 0.3f), 400, Layout::whorl, { thin.front(), thick.front() });
	const PlantForm form = growth.finish();
	const FormMeasure measure = measure_form(form);
	for (const int lod : { 12, 6, 3, 2, 1 }) {
		const FormPlan plan = plan_form(form, measure, vertex_budget(lod));
		CHECK(plan.counts.vertices > 0);
		CHECK(plan.counts.vertices <= vertex_budget(lod));
	}
}

TEST_CASE("parts on a stem that curls up have a stem offset from 0 to 1") {
	for (float bend = 2.0f; bend < 12.5f; bend += 0.25f * static_cast<float>(repetitions(1, 8))) {
		Growth growth(1.0f, 1);
		const std::vector<int> stems = add(growth, axis(1.0f, 0.02f, bend), 1, Layout::ground, { ON_GROUND });
		add(growth, Part(), 60, Layout::along, stems);
		const PlantForm form = growth.finish();
		const BuiltForm mesh = build(form, plan_form(form, measure_form(form), vertex_budget(6)));
		CHECK(std::all_of(mesh.custom0.begin(), mesh.custom0.end(),
				[](const glm::vec4 &attachment) { return attachment.x >= 0.0f && attachment.x <= 1.0f; }));
	}
}

TEST_CASE("a leaf with a width that rises or falls over nearly all of its length is finite") {
	for (const Profile &profile : { Profile{ 7.6f, 1e-9f }, Profile{ 1e-9f, 7.6f }, Profile{ 1e-40f, 8.0f } }) {
		WidthFunction widths;
		widths.profile = profile;
		for (const float s : { 0.0f, 0.01f, 0.5f, 0.99f, 1.0f }) {
			CHECK(std::isfinite(widths.at(s)));
			CHECK(std::isfinite(widths.slope(s)));
		}
		CHECK(std::isfinite(widths.mean()));
	}
}

static PlantForm leaves_one_by_one() {
	Growth growth(0.3f, 1);
	int stem = 0, kind = 0;
	CHECK(growth.add_stem(axis(0.3f, 0.01f), stem) == "");
	CHECK(growth.add_kind(Part(), kind) == "");
	for (int i = 0; i < 200; i++) {
		Arrangement alone;
		alone.from = alone.to = static_cast<float>(i) / 200.0f;
		std::vector<int> handles;
		CHECK(growth.arrange(kind, alone, { stem }, handles) == "");
	}
	return growth.finish();
}

TEST_CASE("a plant with 200 leaves arranged one by one is within its budget") {
	const PlantForm form = leaves_one_by_one();
	const FormPlan plan = plan_form(form, measure_form(form), vertex_budget(6));
	CHECK(plan.counts.vertices <= vertex_budget(6));
}

TEST_CASE("of 200 leaves only as many become coarser at once as the budget needs") {
	const PlantForm form = leaves_one_by_one();
	const FormMeasure measure = measure_form(form);
	const int half_a_leaf = count_part(form.parts[1], details_of(form.parts[1])[0]).vertices / 2;
	for (const int percent : { 95, 85, 75 }) {
		PlanSteps steps(form, measure);
		const int budget = steps.vertices() * percent / 100;
		while (steps.vertices() > budget && steps.take_best(budget)) {
		}
		CHECK(steps.vertices() <= budget);
		CHECK(steps.vertices() > budget - half_a_leaf);
	}
}

namespace {

/// Cost of a plan for a plant with leaves that a script arranged one by one.
int64_t work_of(int leaves, bool is_one_kind) {
	Growth growth(1.0f, 1);
	const std::vector<int> stems = add(growth, axis(1.0f, 0.01f), 1, Layout::ground, { ON_GROUND });
	int kind = 0;
	CHECK(growth.add_kind(Part(), kind) == "");
	for (int i = 0; i < leaves; i++) {
		Part leaf;
		leaf.width = 0.01f + 1e-5f * static_cast<float>(i);
		std::vector<int> handles;
		Arrangement arrangement;
		arrangement.from = arrangement.to = static_cast<float>(i) / static_cast<float>(leaves);
		CHECK((is_one_kind ? "" : growth.add_kind(leaf, kind)) == "");
		CHECK(growth.arrange(kind, arrangement, stems, handles) == "");
	}
	const PlantForm form = growth.finish();
	const FormMeasure measure = measure_form(form);
	PlanSteps steps(form, measure);
	while (steps.vertices() > vertex_budget(3) && steps.take_best(vertex_budget(3))) {
	}
	while (steps.give_back(vertex_budget(3))) {
	}
	CHECK(steps.vertices() > 0);
	CHECK(steps.vertices() <= vertex_budget(3));
	return steps.work();
}

} // namespace

TEST_CASE("the cost of planning grows about with the number of parts, for any arrangement by a script") {
	for (const bool is_one_kind : { true, false }) {
		const int64_t few = work_of(150, is_one_kind);
		const int64_t many = work_of(1500, is_one_kind);
		INFO(few << " parts and groups looked at, and " << many);
		CHECK(many < 30 * few);
	}
}

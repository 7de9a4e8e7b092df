#include "../form/form_species.hpp"
#include "../mesh/form_mesh_fixture.hpp"
#include "card/card_form.hpp"
#include "card/card_strips.hpp"
#include "mesh/level_error.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <algorithm>

using namespace undergrowth;

namespace {

using Grow = PlantForm (*)(uint64_t);
constexpr Grow SPECIES[] = { grow_grass, grow_daisy, grow_fern };
constexpr int BUDGET = 500;

/// A plant of one seed with the pictures of another.
struct CardedPlant {
	PlantForm form;
	CardSheet sheet;
	CardForm cards;
	CardPlan plan;
	BuiltForm mesh;

	CardedPlant(Grow grow, uint64_t seed, int budget = BUDGET) :
			form(grow(seed)), sheet(make_card_sheet(grow(2))), cards(make_card_form(form, measure_form(form), sheet)) {
		plan = plan_cards(cards, sheet, budget);
		mesh.resize(plan.counts);
		if (!plan.is_empty()) {
			build_card_mesh(cards, plan, FormBones(), {}, form.height, mesh.buffers());
		}
	}

	static bool is_card(const glm::vec4 &custom0) { return custom0.z >= static_cast<float>(FIRST_CARD_CODE); }
	SeenMesh seen() const {
		return { mesh.positions.data(), mesh.size(), mesh.indices.data(), static_cast<int>(mesh.indices.size()) };
	}
	SeenCards seen_cards() const {
		SeenCards seen = { mesh.normals.data(), mesh.tangents.data(), mesh.uvs.data(), mesh.custom0.data(),
			mesh.custom2.data(), sheet.width, sheet.height, {} };
		for (const CardLayer &layer : sheet.pictures) {
			seen.layers.push_back(layer.colors.data());
		}
		return seen;
	}
};

} // namespace

TEST_CASE("each part is in a card or in the rest") {
	for (const Grow grow : SPECIES) {
		const CardedPlant plant(grow, 3);
		size_t in_cards = 0;
		for (const CardPlace &place : plant.cards.places) {
			in_cards += static_cast<size_t>(place.count);
		}
		CHECK(in_cards > 0);
		CHECK(in_cards + plant.cards.rest.placed.size() == plant.form.placed.size());
		CHECK(plant.cards.rest.height == plant.form.height);
	}
}

TEST_CASE("cards of buds close to their axis are as wide as the buds") {
	// Three buds whose midribs are close to the axis, at an angle.
	const auto grow_buds = [](float angle) {
		Growth growth(0.3f, 1);
		Part stem, bud;
		stem.kind = bud.kind = PartKind::axis;
		stem.length_min = stem.length_max = 0.3f;
		bud.length_min = bud.length_max = 0.02f;
		stem.width = 0.002f;
		bud.width = 0.006f;
		int stem_kind = 0, bud_kind = 0;
		REQUIRE(growth.add_kind(stem, stem_kind) == "");
		REQUIRE(growth.add_kind(bud, bud_kind) == "");
		Arrangement ground, buds;
		ground.layout = Layout::ground;
		buds.count_min = buds.count_max = 8;
		buds.from = 0.85f;
		buds.angle = { angle, angle };
		std::vector<int> stems, tips;
		REQUIRE(growth.arrange(stem_kind, ground, { ON_GROUND }, stems) == "");
		REQUIRE(growth.arrange(bud_kind, buds, stems, tips) == "");
		return growth.finish();
	};
	const CardSheet sheet = make_card_sheet(grow_buds(0.01f));
	REQUIRE(sheet.groups.size() == 1);
	REQUIRE(sheet.groups[0].shape == CardShape::strip);
	const PlantForm form = grow_buds(0.1f);
	const CardForm cards = make_card_form(form, measure_form(form), sheet);
	const CardPlan plan = plan_cards(cards, sheet, BUDGET);
	REQUIRE(plan.strips.size() == 1);
	float half = 0.0f;
	for (const CardStrip::Row &row : plan.strips[0].rows) {
		half = std::max(half, glm::length(row.right));
	}
	CHECK(half > 0.003f);
	CHECK(half < 0.008f);
}

TEST_CASE("a plan with cards keeps its budget and writes all of its mesh") {
	for (const Grow grow : SPECIES) {
		for (const int budget : { 200, 500, 1100 }) {
			const CardedPlant plant(grow, 3, budget);
			REQUIRE_FALSE(plant.plan.is_empty());
			CHECK(plant.plan.counts.vertices <= budget);
			for (const int32_t index : plant.mesh.indices) {
				CHECK(index >= 0);
				CHECK(index < plant.mesh.size());
			}
			for (const glm::vec3 &normal : plant.mesh.normals) {
				CHECK(glm::length(normal) == doctest::Approx(1.0f));
			}
		}
	}
	CHECK(CardedPlant(grow_fern, 3, 30).plan.is_empty());
}

TEST_CASE("with few vertices, plans draw the carriers of cards before other parts") {
	for (const Grow grow : { grow_fern, grow_daisy }) {
		const CardedPlant plant(grow, 3, 60);
		REQUIRE_FALSE(plant.plan.is_empty());
		CHECK(plant.plan.counts.vertices <= 60);
		CHECK(plant.plan.strips.size() + 1 >= plant.cards.places.size());
	}
}

TEST_CASE("cards have the outline of the parts that they replace") {
	for (const Grow grow : { grow_grass, grow_fern }) {
		const CardedPlant plant(grow, 3);
		const LevelError whole = measure_outline(plant.form);
		const BuiltForm solid = build(plant.form, plan_form(plant.form, measure_form(plant.form), BUDGET));
		const float without = whole.of(
				{ solid.positions.data(), solid.size(), solid.indices.data(), static_cast<int>(solid.indices.size()) });
		CHECK(whole.of(plant.seen(), plant.seen_cards()) < 0.75f * without);
	}
}

TEST_CASE("open heads as broad as long have the outline of their parts from all heights") {
	for (const uint64_t seed : { 1, 4 }) {
		const PlantForm form = grow_grass(seed); // Its panicles are open.
		const CardSheet sheet = make_card_sheet(grow_grass(1));
		REQUIRE(sheet.groups.size() == 1);
		CHECK(sheet.groups[0].shape == CardShape::head);
		CHECK(sheet.pictures.size() == HEAD_VIEW_COUNT);
	}
}

TEST_CASE("a head is one quad, whose edges contain its parts from all heights") {
	const CardedPlant plant(grow_daisy, 3);
	for (const CardPlace &place : plant.cards.places) {
		CHECK(count_card(plant.sheet, place, CARD_ROWS[0]) == 4);
	}
	const HeadOutline &head = plant.sheet.pictures[0].head;
	CHECK(head.half > 0.015f);
	for (size_t view = 0; view < HEAD_VIEW_COUNT; view++) {
		const CardLayer &layer = plant.sheet.pictures[view];
		CHECK(layer.box.low == doctest::Approx(head_edge(head.low, HEAD_VIEWS[view])));
		CHECK(layer.box.high == doctest::Approx(head_edge(head.high, HEAD_VIEWS[view])));
		CHECK((view == 0 ||
				layer.box.high - layer.box.low >
						1.3f * (plant.sheet.pictures[view - 1].box.high - plant.sheet.pictures[view - 1].box.low)));
	}
	CHECK(head_picture(-1.0f) == 0.0f);
	CHECK(head_picture(HEAD_VIEWS[1]) == doctest::Approx(1.0f));
	CHECK(head_picture(0.5f * (HEAD_VIEWS[1] + HEAD_VIEWS[2])) == doctest::Approx(1.5f));
	CHECK(head_picture(1.0f) == HEAD_VIEW_COUNT - 1);
}

TEST_CASE("heads grow where their carriers are not drawn") {
	const CardedPlant plant(grow_daisy, 2); // Three stems.
	FormPlan plan = plant.plan.rest;
	const auto radius = [&](const FormPlan &of) {
		const std::vector<CardStrip> strips = make_strips(plant.cards, plant.sheet, of, CARD_ROWS[0]);
		return glm::length(strips.front().rows.front().right - strips.front().rows.front().left);
	};
	const float before = radius(plan);
	const int dropped = plant.cards.places.back().carrier;
	plan.fates[static_cast<size_t>(dropped)] = FormPlan::dropped;
	float all = 0.0f;
	float drawn = 0.0f;
	for (const CardPlace &place : plant.cards.places) {
		const float area = place.extent.half * place.extent.half;
		all += area;
		drawn += place.carrier == dropped ? 0.0f : area;
	}
	CHECK(all / drawn == doctest::Approx(3.0f / 2.0f).epsilon(0.1));
	CHECK(radius(plan) == doctest::Approx(before * std::sqrt(all / drawn)));
}

TEST_CASE("flat cards are clockwise from the side of their normals") {
	const CardedPlant plant(grow_fern, 3);
	int quads = 0;
	for (size_t i = 0; i < plant.mesh.indices.size(); i += 3) {
		const auto at = [&](size_t k) { return static_cast<size_t>(plant.mesh.indices[i + k]); };
		if (CardedPlant::is_card(plant.mesh.custom0[at(0)])) {
			const glm::vec3 &a = plant.mesh.positions[at(0)];
			const glm::vec3 turn = glm::cross(plant.mesh.positions[at(1)] - a, plant.mesh.positions[at(2)] - a);
			CHECK(glm::dot(turn, plant.mesh.normals[at(0)]) < 0.0f);
			quads++;
		}
	}
	CHECK(quads > 7 * 4);
}

TEST_CASE("cards bend and swing as the parts that they replace") {
	const CardedPlant fern(grow_fern, 3);
	for (size_t i = 0; i < fern.mesh.positions.size(); i++) {
		if (CardedPlant::is_card(fern.mesh.custom0[i])) { // Fronds bend as the stalks that carry them.
			const glm::vec3 middle = fern.mesh.positions[i] - glm::vec3(fern.mesh.custom2[i]);
			CHECK(fern.mesh.custom0[i].x == doctest::Approx(stem_offset_of(fern.form, middle)));
			CHECK(fern.mesh.custom0[i].y == 0.0f);
		}
	}
	const CardedPlant daisy(grow_daisy, 3);
	int of_heads = 0;
	for (size_t i = 0; i < daisy.mesh.positions.size(); i++) {
		if (CardedPlant::is_card(daisy.mesh.custom0[i])) { // Heads turn as a whole about the tip of their stem.
			CHECK(daisy.mesh.custom0[i].y == 1.0f);
			CHECK(daisy.mesh.custom1[i].y > 0.3f * daisy.form.height);
			of_heads++;
		}
	}
	CHECK(of_heads > 0);
}

TEST_CASE("meshes with cards are the same on every platform") {
	const uint64_t goldens[3] = { 0x95efb72fce8b893bull, 0xa713e54588493f75ull, 0x5f07b5b634cbf952ull };
	for (size_t i = 0; i < 3; i++) {
		CHECK(CardedPlant(SPECIES[i], 5).mesh.hash() == goldens[i]);
	}
}

TEST_CASE("cards on twigs have the swings of their twigs in the whole plant") {
	Growth growth(0.4f, 1);
	Part stem, branch, twig, bud;
	stem.kind = branch.kind = twig.kind = PartKind::axis;
	stem.length_min = stem.length_max = 0.3f;
	branch.length_min = branch.length_max = 0.2f;
	twig.length_min = twig.length_max = 0.1f;
	stem.frequency = 0.0f;
	branch.frequency = 1.4f;
	twig.frequency = 2.2f;
	stem.width = branch.width = twig.width = 0.003f;
	bud.length_min = bud.length_max = 0.008f;
	bud.width = 0.003f;
	bud.frequency = 0.0f;
	int kind = 0;
	for (const Part &part : { stem, branch, twig, bud }) {
		REQUIRE(growth.add_kind(part, kind) == "");
	}
	Arrangement ground, few, buds;
	ground.layout = Layout::ground;
	ground.count_min = ground.count_max = 2;
	few.count_min = few.count_max = 4;
	few.angle = buds.angle = { 0.9f, 0.5f };
	few.from = buds.from = 0.2f;
	buds.count_min = buds.count_max = 60;
	std::vector<int> stems, branches, twigs, all;
	REQUIRE(growth.arrange(0, ground, { ON_GROUND }, stems) == "");
	REQUIRE(growth.arrange(1, few, stems, branches) == "");
	REQUIRE(growth.arrange(2, few, branches, twigs) == "");
	REQUIRE(growth.arrange(3, buds, twigs, all) == "");
	const PlantForm form = growth.finish();
	const FormMeasure measure = measure_form(form);
	const CardSheet sheet = make_card_sheet(form);
	REQUIRE(sheet.has_far_cards());
	for (const CardReach reach : { CardReach::near, CardReach::far }) {
		CAPTURE(static_cast<int>(reach));
		const std::vector<int> &carriers = reach == CardReach::near ? twigs : branches;
		const CardForm cards = make_card_form(form, measure, sheet, reach);
		const CardPlan plan = plan_cards(cards, sheet, 5000);
		REQUIRE(plan.strips.size() == carriers.size());
		BuiltForm mesh;
		mesh.resize(plan.counts);
		build_card_mesh(cards, plan, FormBones(), {}, form.height, mesh.buffers());
		int found = 0;
		for (size_t i = 0; i < mesh.positions.size(); i++) {
			if (!CardedPlant::is_card(mesh.custom0[i])) {
				continue;
			}
			const InnerVertex &inner = mesh.inner[0][i];
			CHECK(std::any_of(carriers.begin(), carriers.end(), [&](int handle) {
				const PartAttachment &own = measure.attachments[static_cast<size_t>(handle)];
				return own.inner[0].code.pace == inner.code.pace && own.inner[0].code.place == inner.code.place &&
						own.code.pace == mesh.custom1[i].w;
			}));
			found += inner.weight > 0.5f ? 1 : 0;
		}
		CHECK(found >= (reach == CardReach::near ? static_cast<int>(twigs.size()) : 0));
	}
}

#include "../form/form_species.hpp"
#include "../mesh/form_mesh_fixture.hpp"
#include "card/card_form.hpp"
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
			form(grow(seed)), sheet(make_card_sheet(grow(2))), cards(make_card_form(form, sheet)) {
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
		SeenCards seen = { mesh.normals.data(), mesh.uvs.data(), mesh.custom0.data(), mesh.custom2.data(), sheet.width,
			sheet.height, {} };
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
	CHECK(CardedPlant(grow_tulip, 3).plan.is_empty());
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
	const uint64_t goldens[3] = { 0x4c1a15495c58bd3cull, 0xe1ccdd9f795ee9ddull, 0x8006b1c8f5f0e570ull };
	for (size_t i = 0; i < 3; i++) {
		CHECK(CardedPlant(SPECIES[i], 5).mesh.hash() == goldens[i]);
	}
}

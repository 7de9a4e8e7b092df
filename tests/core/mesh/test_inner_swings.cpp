// Swings of twigs and leaves on swinging branches.

#include "form_mesh_fixture.hpp"

#include "../form/form_species.hpp"
#include "motion/part_bend.hpp"

#include <doctest/doctest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <string>

using namespace undergrowth;

namespace {

struct Shrub {
	PlantForm form = grow_shrub(3);
	std::vector<PartAttachment> attachments = attach_parts(form);
	FormBones bones = FormBones(form, attachments);
	BuiltForm mesh = build(form, plan_form(form, measure_form(form), 20000), 0.0f, {}, bones);
};

StemMotion gust() {
	StemMotion stem;
	stem.bend = { 0.12f, -0.04f };
	stem.rate = { -0.3f, 0.2f };
	stem.clock = 0.123f;
	stem.air = 4.0f;
	return stem;
}

/// Position of a vertex in the shaders of fields: the innermost swing first.
glm::vec3 shaded(const BuiltForm &mesh, size_t i, const StemMotion &stem, int orders) {
	glm::vec3 vertex = mesh.positions[i];
	CarrierSwing chain[1 + MAX_INNER_SWINGS];
	chain[0] = { glm::vec3(mesh.custom1[i]), mesh.custom0[i].y,
		decode_part_motion({ mesh.custom1[i].w, mesh.custom2[i].w }) };
	int count = mesh.custom0[i].y > 0.0f ? 1 : 0;
	for (int k = 0; k < orders && count == k + 1 && mesh.inner[k][i].weight > 0.0f; k++) {
		const InnerVertex &inner = mesh.inner[k][i];
		chain[count++] = { inner.pivot, inner.weight, decode_part_motion(inner.code) };
	}
	for (int k = count - 1; k >= 0; k--) {
		const glm::vec2 bend = part_bend(chain[k].swing, stem, chain, k);
		vertex = chain[k].pivot + bent_way(vertex - chain[k].pivot, bend, chain[k].weight);
	}
	return glm::mix(vertex, turned(vertex, stem.bend), mesh.custom0[i].x);
}

bool is_twig_bone(const Shrub &plant, int bone) {
	return bone >= FormBones::FIRST &&
			plant.bones.bones()[static_cast<size_t>(bone - FormBones::FIRST)].carried_by >= 0;
}

} // namespace

TEST_CASE("only plants with branches on branches have inner swings") {
	for (const PlantForm &form : { grow_grass(3), grow_tulip(3), grow_daisy(3), grow_fern(3), grow_cereal(3) }) {
		CHECK_FALSE(has_branched_branches(form));
		for (const PartAttachment &attachment : attach_parts(form)) {
			CHECK(attachment.inner_count == 0);
		}
	}
	CHECK(has_branched_branches(grow_shrub(3)));
}

TEST_CASE("branches, twigs and leaves of a shrub have a swing each, on that of their carrier") {
	const Shrub plant;
	int twigs = 0, leaves_on_twigs = 0, leaves_on_branches = 0;
	for (size_t i = 0; i < plant.attachments.size(); i++) {
		const PartAttachment &own = plant.attachments[i];
		const PlacedPart &part = plant.form.placed[i];
		const int depth = plant.form.groups[static_cast<size_t>(part.group)].depth;
		const bool is_leaf = plant.form.parts[static_cast<size_t>(part.kind)].kind == PartKind::blade;
		CHECK(own.has_swing == (depth >= 2));
		CHECK(own.inner_count == std::max(depth - 2, 0));
		if (depth >= 3) {
			const InnerSwing &inner = own.inner[static_cast<size_t>(own.inner_count - 1)];
			CHECK(inner.swings);
			CHECK(inner.pivot == part.base);
			CHECK(inner.swinger == static_cast<int>(i));
			CHECK(own.weight < 1.0001f);
		}
		if (depth == 4) {
			CHECK(own.inner[0].weight == part.offset);
			CHECK(own.inner[0].swinger == part.carrier);
		}
		twigs += depth == 3 && !is_leaf ? 1 : 0;
		leaves_on_branches += depth == 3 && is_leaf ? 1 : 0;
		leaves_on_twigs += depth == 4 ? 1 : 0;
	}
	CHECK(twigs == 24);
	CHECK(leaves_on_twigs == 96);
	CHECK(leaves_on_branches == 16);
}

TEST_CASE("twigs stay on their branches and leaves on their twigs, whatever swings") {
	const Shrub plant;
	const StemMotion stem = gust();
	for (size_t i = 0; i < plant.attachments.size(); i++) {
		const PartAttachment &own = plant.attachments[i];
		if (own.inner_count == 0) {
			continue;
		}
		// The place of a twig's base in the swings of its carriers is the same with its own swing.
		CarrierSwing chain[1 + MAX_INNER_SWINGS] = { { own.pivot, own.weight, own.swing } };
		for (int k = 0; k < own.inner_count; k++) {
			const InnerSwing &inner = own.inner[static_cast<size_t>(k)];
			chain[k + 1] = { inner.pivot, inner.weight_at(0.0f), inner.swing };
		}
		glm::vec3 base = plant.form.placed[i].base;
		const CarrierSwing &last = chain[own.inner_count];
		const glm::vec2 bend = part_bend(last.swing, stem, chain, own.inner_count);
		CHECK(glm::distance(last.pivot + bent_way(base - last.pivot, bend, last.weight), base) < 1e-6f);
	}
}

TEST_CASE("each order of branches moves on its own") {
	const Shrub plant;
	float of_twigs = 0.0f, of_leaves = 0.0f;
	for (size_t i = 0; i < plant.mesh.positions.size(); i++) {
		const glm::vec3 whole = shaded(plant.mesh, i, gust(), 2);
		of_twigs =
				std::max(of_twigs, glm::distance(shaded(plant.mesh, i, gust(), 1), shaded(plant.mesh, i, gust(), 0)));
		of_leaves = std::max(of_leaves, glm::distance(whole, shaded(plant.mesh, i, gust(), 1)));
	}
	MESSAGE("twigs move by " << of_twigs << " m on their branches, leaves by " << of_leaves << " m on twigs");
	CHECK(of_twigs > 0.01f);
	CHECK(of_leaves > 0.005f);
}

TEST_CASE("a shrub has bones for branches as before, and more for twigs") {
	const Shrub plant;
	const std::vector<PartBone> &bones = plant.bones.bones();
	int twigs = 0;
	for (size_t i = 0; i < bones.size(); i++) {
		if (bones[i].carried_by >= 0) {
			twigs++;
			CHECK(bones[i].carried_by < static_cast<int>(i));
			CHECK(bones[static_cast<size_t>(bones[i].carried_by)].carried_by < 0);
			CHECK(plant.bones.names()[i] == "twig_" + std::to_string(twigs));
		}
	}
	CHECK(twigs == FormBones::MAX_INNER_BONES);
	CHECK(bones.size() <= FormBones::MAX_BONES - FormBones::FIRST + FormBones::MAX_INNER_BONES);
}

TEST_CASE("vertices of twigs have weights that sum to 1 exactly") {
	const Shrub plant;
	const int count = FormBones::FIRST + static_cast<int>(plant.bones.bones().size());
	int of_twigs = 0;
	for (size_t i = 0; i < plant.mesh.positions.size(); i++) {
		const float *weights = plant.mesh.weights.data() + 4 * i;
		REQUIRE(weights[0] + weights[1] + weights[2] + weights[3] == 1.0f);
		for (size_t k = 4 * i; k < 4 * i + 4; k++) {
			REQUIRE((plant.mesh.weights[k] >= 0.0f && plant.mesh.bones[k] >= 0 && plant.mesh.bones[k] < count));
		}
		of_twigs += is_twig_bone(plant, plant.mesh.bones[4 * i + 2]) ? 1 : 0;
	}
	CHECK(of_twigs > 100);
}

TEST_CASE("a skeleton shows the same swing of twigs as shaders") {
	const Shrub plant;
	float worst = 0.0f;
	float max = 0.0f;
	for (size_t i = 0; i < plant.mesh.positions.size(); i++) {
		if (is_twig_bone(plant, plant.mesh.bones[4 * i + 2])) {
			const glm::vec3 shown = shaded(plant.mesh, i, gust(), 1);
			worst = std::max(worst, glm::distance(skinned(plant.mesh, plant.bones, i, gust()), shown));
			max = std::max(max, glm::distance(shaded(plant.mesh, i, gust(), 0), shown));
		}
	}
	MESSAGE("the skeleton is " << worst << " m off, twigs move by " << max << " m");
	CHECK(max > 0.01f);
	CHECK(worst < 0.25f * max);
}

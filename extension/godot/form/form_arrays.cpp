#include "form/form_arrays.hpp"

#include "form/shared_cards.hpp"
#include "mesh/facets.hpp"
#include "mesh/form_mesh.hpp"
#include "mesh/joint_binding.hpp"
#include "mesh/packed_vertex.hpp"
#include "plants/part_skeleton.hpp"

#include <algorithm>

using namespace godot;

namespace undergrowth {

// All are floats: the Compatibility renderer reads two of four half floats only.
static constexpr int64_t CUSTOM_FORMAT = custom_format(0, Mesh::ARRAY_CUSTOM_RGBA_FLOAT) |
		custom_format(1, Mesh::ARRAY_CUSTOM_RGBA_FLOAT) | custom_format(2, Mesh::ARRAY_CUSTOM_RGBA_FLOAT) |
		custom_format(3, Mesh::ARRAY_CUSTOM_RGBA_FLOAT);

// The engine's arrays of a mesh, with their size, as buffers of the core.
struct FormArrays {
	PackedVector3Array positions, normals;
	PackedColorArray colors;
	PackedVector2Array uvs;
	PackedFloat32Array tangents, weights, custom0, custom1, custom2, stem_places;
	PackedInt32Array bones, indices;
	std::vector<InnerVertex> inner[MAX_INNER_SWINGS]; ///< Empty: not written.

	explicit FormArrays(const MeshCounts &counts) {
		positions.resize(counts.vertices);
		normals.resize(counts.vertices);
		colors.resize(counts.vertices);
		uvs.resize(counts.vertices);
		tangents.resize(4 * counts.vertices);
		weights.resize(4 * counts.vertices);
		custom0.resize(4 * counts.vertices);
		custom1.resize(4 * counts.vertices);
		custom2.resize(4 * counts.vertices);
		stem_places.resize(counts.vertices);
		bones.resize(4 * counts.vertices);
		indices.resize(counts.indices);
	}
	void add_inner(const MeshCounts &counts) {
		for (std::vector<InnerVertex> &order : inner) {
			order.resize(size_t(counts.vertices));
		}
	}
	FormBuffers buffers() {
		FormBuffers to;
		to.positions = reinterpret_cast<glm::vec3 *>(positions.ptrw());
		to.normals = reinterpret_cast<glm::vec3 *>(normals.ptrw());
		to.tangents = reinterpret_cast<glm::vec4 *>(tangents.ptrw());
		to.colors = reinterpret_cast<glm::vec4 *>(colors.ptrw());
		to.uvs = reinterpret_cast<glm::vec2 *>(uvs.ptrw());
		to.custom0 = reinterpret_cast<glm::vec4 *>(custom0.ptrw());
		to.custom1 = reinterpret_cast<glm::vec4 *>(custom1.ptrw());
		to.custom2 = reinterpret_cast<glm::vec4 *>(custom2.ptrw());
		to.stem_places = stem_places.ptrw();
		to.bones = bones.ptrw();
		to.weights = weights.ptrw();
		to.indices = indices.ptrw();
		for (size_t k = 0; k < MAX_INNER_SWINGS; k++) {
			to.inner[k] = inner[k].empty() ? nullptr : inner[k].data();
		}
		return to;
	}
};

static Array packed(const FormArrays &from) {
	Array arrays;
	arrays.resize(Mesh::ARRAY_MAX);
	arrays[Mesh::ARRAY_VERTEX] = from.positions;
	arrays[Mesh::ARRAY_NORMAL] = from.normals;
	arrays[Mesh::ARRAY_TANGENT] = from.tangents;
	arrays[Mesh::ARRAY_COLOR] = from.colors;
	arrays[Mesh::ARRAY_TEX_UV] = from.uvs;
	arrays[Mesh::ARRAY_CUSTOM0] = from.custom0;
	arrays[Mesh::ARRAY_CUSTOM1] = from.custom1;
	arrays[Mesh::ARRAY_CUSTOM2] = from.custom2;
	arrays[Mesh::ARRAY_BONES] = from.bones;
	arrays[Mesh::ARRAY_WEIGHTS] = from.weights;
	arrays[Mesh::ARRAY_INDEX] = from.indices;
	return arrays;
}

static PackedFloat32Array packed_swings(const std::vector<InnerVertex> &swings) {
	PackedFloat32Array all;
	all.resize(int64_t(swings.size()) * PackedSwing::WORDS);
	float *to = all.ptrw();
	for (const InnerVertex &swing : swings) {
		const PackedSwing packed = pack_swing(swing);
		to = std::copy(packed.words, packed.words + PackedSwing::WORDS, to);
	}
	return all;
}

// Returns CUSTOM3 of every vertex: the height of the shown plant, the position of attachment on the stem, and x and z
// in calm air.
static PackedFloat32Array at_rest(const SampledPlant &sampled, const FormArrays &arrays) {
	PackedFloat32Array all;
	all.resize(4 * arrays.positions.size());
	float *to = all.ptrw();
	std::vector<Transform3D> bones;
	if (sampled.rest != glm::vec2(0.0f)) {
		bones = PartSkeleton::at_rest(sampled);
	}
	for (int64_t i = 0; i < arrays.positions.size(); i++) {
		Vector3 place = bones.empty() ? arrays.positions[i] : Vector3();
		for (int64_t k = 4 * i; k < 4 * i + 4 && !bones.empty(); k++) {
			place += bones[size_t(arrays.bones[k])].xform(arrays.positions[i]) * arrays.weights[k];
		}
		*to++ = sampled.height;
		*to++ = arrays.stem_places[i];
		*to++ = float(place.x);
		*to++ = float(place.z);
	}
	return all;
}

// `counts`: of the mesh of the measured parts, the first part of the arrays. Cards need no factor.
static Vector2 from_above(const FormMeasure &measure, const MeshCounts &counts, const FormArrays &arrays) {
	float side = 0.0f;
	for (const float outline : measure.outlines) {
		side += outline / float(OUTLINES);
	}
	const float own = area_from_above({ reinterpret_cast<const glm::vec3 *>(arrays.positions.ptr()), counts.vertices,
			arrays.indices.ptr(), counts.indices });
	return side > 0.0f ? Vector2(measure.from_above, own) / side : Vector2();
}

// Near cards, or far ones where the near ones are too many. Empty if none fit.
static CardPlan plan_any_cards(const GrownPlant &grown, const SampledPlant &sampled, int rows, const CardForm *&form) {
	CardPlan cards;
	for (const CardReach reach : { CardReach::near, CardReach::far }) {
		const bool is_offered = sampled.cards && (reach == CardReach::near || sampled.cards->sheet().has_far_cards());
		if (is_offered && cards.is_empty()) {
			form = &grown.card_form(sampled.cards->sheet(), reach);
			cards = plan_cards(*form, sampled.cards->sheet(), vertex_budget(sampled.lod), rows);
		}
	}
	return cards;
}

MeshArrays build_form_arrays(const GrownPlant &grown, const SampledPlant &sampled, Vector2 *above) {
	const int rows = sampled.stem ? sampled.stem->joints : 0;
	const CardForm *card_form = nullptr;
	const CardPlan cards = plan_any_cards(grown, sampled, rows, card_form);
	FormPlan plan;
	if (cards.is_empty()) {
		plan = plan_form(grown.form, grown.measure(), vertex_budget(sampled.lod));
		divide_carriers(grown.form, rows, plan);
	}
	const MeshCounts counts = cards.is_empty() ? plan.counts : cards.counts;
	FormArrays arrays(counts);
	if (sampled.is_packed && grown.has_orders) {
		arrays.add_inner(counts);
	}
	const FormBones none;
	if (cards.is_empty()) {
		build_form_mesh(grown.form, grown.measure(), plan, sampled.has_part_bones ? grown.bones : none, sampled.options,
				sampled.height, arrays.buffers());
	} else {
		build_card_mesh(*card_form, cards, none, sampled.options, sampled.height, arrays.buffers());
	}
	if (above) {
		*above = cards.is_empty() ? from_above(grown.measure(), counts, arrays)
								  : from_above(card_form->measure, cards.rest.counts, arrays);
	}
	if (sampled.stem) {
		bind_to_joints(sampled.stem->joints, counts.vertices, arrays.stem_places.ptr(), arrays.bones.ptrw(),
				arrays.weights.ptrw());
	}
	Array all = packed(arrays);
	all[Mesh::ARRAY_CUSTOM3] = at_rest(sampled, arrays);
	MeshArrays made = { all, CUSTOM_FORMAT, sampled.material, true, !cards.is_empty(),
		cards.is_empty() ? has_open_bodies(grown.form, plan) : cards.rest.body_count > 0,
		cards.is_empty() ? facets_of(grown.form, plan) : facets_of(card_form->rest, cards.rest) };
	for (size_t k = 0; k < MAX_INNER_SWINGS; k++) {
		made.inner[k] = packed_swings(arrays.inner[k]);
	}
	return made;
}

} // namespace undergrowth

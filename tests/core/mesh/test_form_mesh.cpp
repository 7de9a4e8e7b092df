#include "../form/form_species.hpp"
#include "form_mesh_fixture.hpp"
#include "mesh/form_body.hpp"
#include "mesh/part_template.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace undergrowth;

namespace {

using Grow = PlantForm (*)(uint64_t);
constexpr Grow SPECIES[] = { grow_grass, grow_tulip, grow_daisy };
constexpr int LEVELS[] = { 12, 6, 3, 2, 1 };

BuiltForm build_level(const PlantForm &form, int lod) {
	return build(form, plan_form(form, measure_form(form), vertex_budget(lod)));
}

/// One edge (m) of the blades of a form's group, at a detail.
std::vector<glm::vec3> edge_of(const PlantForm &form, size_t group, const PartDetail &detail) {
	const size_t kind = static_cast<size_t>(form.groups[group].kind);
	const Part &part = form.parts[kind];
	const PartTemplate shape = make_part_template(part, form.midribs[kind], detail, mean_color(part));
	std::vector<glm::vec3> edge;
	for (int row = 0; row <= detail.rows; row++) {
		const SurfacePoint &point = shape.vertices[static_cast<size_t>(row * detail.columns)].point;
		edge.push_back(point.middle * part.mean_length() + point.aside * part.width);
	}
	return edge;
}

/// m.
float distance_to_edge(const std::vector<glm::vec3> &edge, const glm::vec3 &place) {
	float min = 1e30f;
	for (size_t i = 1; i < edge.size(); i++) {
		const glm::vec3 way = edge[i] - edge[i - 1];
		const float share = glm::clamp(glm::dot(place - edge[i - 1], way) / glm::dot(way, way), 0.0f, 1.0f);
		min = std::min(min, glm::distance(place, edge[i - 1] + share * way));
	}
	return min;
}

/// Checks all guarantees of a mesh.
void check_sound(const BuiltForm &mesh) {
	for (const int32_t index : mesh.indices) {
		CHECK((index >= 0 && index < mesh.size()));
	}
	for (int i = 0; i < mesh.size(); i++) {
		const size_t k = static_cast<size_t>(i);
		CHECK(std::abs(glm::length(mesh.normals[k]) - 1.0f) < 1e-5f);
		CHECK(std::abs(glm::length(glm::vec3(mesh.tangents[k])) - 1.0f) < 1e-5f);
		CHECK(mesh.weights[4 * k] + mesh.weights[4 * k + 1] == 1.0f);
		CHECK(mesh.weights[4 * k + 1] == mesh.custom0[k].x);
		CHECK((mesh.custom0[k].x >= 0.0f && mesh.custom0[k].x <= 1.0f));
		CHECK((mesh.custom0[k].y >= 0.0f && mesh.custom0[k].y <= 1.0f));
		CHECK((mesh.colors[k].w > 0.0f && mesh.colors[k].w <= 1.0f));
		CHECK(std::isfinite(glm::dot(mesh.positions[k], mesh.positions[k])));
	}
}

/// Fraction of the triangles (by area) with corner normals on their clockwise side.
double share_facing_front(const BuiltForm &mesh) {
	double facing = 0.0;
	double whole = 0.0;
	for (size_t i = 0; i < mesh.indices.size(); i += 3) {
		const size_t a = static_cast<size_t>(mesh.indices[i]);
		const size_t b = static_cast<size_t>(mesh.indices[i + 1]);
		const size_t c = static_cast<size_t>(mesh.indices[i + 2]);
		const glm::vec3 front =
				glm::cross(mesh.positions[c] - mesh.positions[a], mesh.positions[b] - mesh.positions[a]);
		const double area = glm::length(front);
		whole += area;
		facing += glm::dot(front, mesh.normals[a] + mesh.normals[b] + mesh.normals[c]) > 0.0f ? area : 0.0;
	}
	return facing / whole;
}

} // namespace

TEST_CASE("budgets of vertices are 5.5 times the squared segments, and at least 12") {
	CHECK(vertex_budget(12) == 792);
	CHECK(vertex_budget(6) == 198);
	CHECK(vertex_budget(3) == 50);
	CHECK(vertex_budget(2) == 22);
	CHECK(vertex_budget(1) == 12);
}

TEST_CASE("meshes of parts stay in their budget, fill their buffers, and are sound") {
	for (const Grow grow : SPECIES) {
		for (const uint64_t seed : { 1, 2, 3 }) {
			const PlantForm form = grow(seed);
			for (const int lod : LEVELS) {
				const BuiltForm mesh = build_level(form, lod);
				CHECK(mesh.size() <= vertex_budget(lod));
				CHECK(mesh.size() >= vertex_budget(lod) / 2);
				check_sound(mesh);
			}
		}
	}
}

TEST_CASE("triangles are clockwise from the side that their normals point to") {
	for (const Grow grow : SPECIES) {
		CHECK(share_facing_front(build_level(grow(2), 40)) > 0.99);
		CHECK(share_facing_front(build_level(grow(2), 3)) > 0.9);
	}
}

TEST_CASE("counts of a part are those of its template, at every detail") {
	Part part;
	for (const PartKind kind : { PartKind::axis, PartKind::blade, PartKind::bead }) {
		part.kind = kind;
		for (const float fall : { 0.0f, 0.5f }) {
			part.widths.profile.fall = fall;
			part.blade.teeth = fall > 0.0f ? 5 : 0;
			part.axis.tip_diameter = 0.02f;
			part.axis.open_tip = fall > 0.0f;
			for (const PartDetail &detail : details_of(part, true)) { // The usual details are among them.
				const PartTemplate shape = make_part_template(part, Midrib({}), detail, mean_color(part));
				const MeshCounts counts = count_part(part, detail);
				CHECK(static_cast<int>(shape.vertices.size()) == counts.vertices);
				CHECK(static_cast<int>(shape.indices.size()) == counts.indices);
			}
		}
	}
}

TEST_CASE("details cost less and less") {
	for (const PartKind kind : { PartKind::axis, PartKind::blade, PartKind::bead }) {
		for (const bool is_close : { false, true }) {
			Part part;
			part.kind = kind;
			part.axis.lobes = is_close ? 5 : 0;
			part.blade.roll = is_close ? 0.6f : 0.0f;
			const std::vector<PartDetail> details = details_of(part, is_close);
			for (size_t i = 1; i < details.size(); i++) {
				CHECK(count_part(part, details[i]).vertices < count_part(part, details[i - 1]).vertices);
			}
		}
	}
}

TEST_CASE("petals that fill the picture have round edges, and all other details have the same cost") {
	const PlantForm form = grow_tulip(1);
	const FormMeasure measure = measure_form(form);
	constexpr size_t PETALS = 2;
	const std::vector<glm::vec3> true_edge = edge_of(form, PETALS, { 9, 200 });
	const auto farthest = [&](int lod) {
		const PartDetail detail = plan_form(form, measure, vertex_budget(lod)).groups[PETALS].detail;
		const std::vector<glm::vec3> edge = edge_of(form, PETALS, detail);
		float max = 0.0f;
		for (const glm::vec3 &place : true_edge) {
			max = std::max(max, distance_to_edge(edge, place));
		}
		return max;
	};
	constexpr float SEEN = 0.0003f; // m: a pixel when a flower of 8 cm fills 270 pixels.
	CHECK(farthest(24) < SEEN);
	CHECK(farthest(12) > SEEN);
	CHECK(plan_form(form, measure, vertex_budget(12)).groups[PETALS].detail.rows <= 8);
}

TEST_CASE("mouths of bells that fill the picture follow each of their lobes") {
	Part bell;
	bell.kind = PartKind::axis;
	bell.axis.lobes = 7;
	CHECK(details_of(bell, true).front().columns == 28);
	bell.axis.lobes = 0;
	CHECK(details_of(bell, true).front() == details_of(bell).front()); // A stem is already round enough.
	bell.axis.open_tip = true;
	CHECK(details_of(bell, true).front().columns == 20);
}

TEST_CASE("leaves have the stem offset, pivot and rank of their attachment") {
	const PlantForm form = grow_tulip(1);
	const BuiltForm mesh = build_level(form, 40);
	const PlacedPart &leaf = form.placed[static_cast<size_t>(form.groups[1].first)];
	const float expected = form.point_of(form.placed[0], leaf.offset).y / form.height;
	int found = 0;
	for (size_t i = 0; i < mesh.positions.size(); i++) {
		const glm::vec3 shift = glm::vec3(mesh.custom1[i]) - leaf.base; // Relative to the stem as drawn.
		if (glm::length(shift) < 1e-3f) {
			found++;
			CHECK((mesh.custom0[i].x >= expected && mesh.custom0[i].x < expected + 0.03f)); // Between rows of the stem.
			CHECK(std::abs(mesh.custom0[i].y - (1.0f - mesh.uvs[i].y)) < 1e-6f);
			CHECK(decode_part_motion({ mesh.custom1[i].w, mesh.custom2[i].w }).frequency == 3.0f);
			const glm::vec3 midrib = mesh.positions[i] - glm::vec3(mesh.custom2[i]);
			CHECK(glm::length(midrib - shift - form.point_of(leaf, mesh.custom0[i].y)) < 1e-5f);
			CHECK(std::abs(mesh.stem_places[i] - expected) < 0.01f);
		}
	}
	CHECK(found > 20);
}

TEST_CASE("the venation of a part follows from its shape and colour unless it is set") {
	Part leaf;
	leaf.length_min = leaf.length_max = 0.3f;
	leaf.width = 0.01f;
	CHECK(venation_of(leaf) == Venation::parallel);
	leaf.width = 0.1f;
	CHECK(venation_of(leaf) == Venation::pinnate);
	leaf.colors.base = leaf.colors.tip = { 0.9f, 0.2f, 0.1f, 1.0f };
	CHECK(venation_of(leaf) == Venation::radial);
	leaf.venation = Venation::palmate;
	CHECK(venation_of(leaf) == Venation::palmate);
	Part axis;
	axis.kind = PartKind::axis;
	CHECK(venation_of(axis) == Venation::none);
	axis.axis.open_tip = true;
	CHECK(venation_of(axis) == Venation::radial);
}

TEST_CASE("vertices have the code of the venation beside their rank") {
	Part leaf;
	for (const Venation veins : { Venation::none, Venation::parallel, Venation::palmate, Venation::radial }) {
		leaf.venation = veins;
		const BuiltForm mesh = build_level(grow_alone(leaf), 12);
		const int code = static_cast<int>(veins) - static_cast<int>(Venation::none);
		for (const glm::vec4 &custom : mesh.custom0) {
			CHECK(static_cast<int>(custom.z) == code);
		}
	}
}

TEST_CASE("a stem's vertices have the offset of their own height and do not swing") {
	Part part;
	part.kind = PartKind::axis;
	part.length_min = part.length_max = 0.5f;
	const PlantForm form = grow_alone(part);
	const BuiltForm mesh = build_level(form, 12);
	for (size_t i = 0; i < mesh.positions.size(); i++) {
		CHECK(std::abs(mesh.custom0[i].x - mesh.positions[i].y / form.height) < 1e-6f);
		CHECK(mesh.custom0[i].y == 0.0f);
	}
}

TEST_CASE("the base and the inside of a tuft are darker than its tips") {
	const PlantForm form = grow_grass(1);
	const BuiltForm mesh = build_level(form, 12);
	float darkest = 1.0f;
	float lightest = 0.0f;
	for (size_t i = 0; i < mesh.positions.size(); i++) {
		(mesh.positions[i].y < 0.01f ? darkest : lightest) = mesh.positions[i].y < 0.01f
				? std::min(darkest, mesh.colors[i].w)
				: std::max(lightest, mesh.colors[i].w);
	}
	CHECK(darkest < 0.25f);
	CHECK(darkest > 0.1f);
	CHECK(lightest > 0.9f);
}

TEST_CASE("a stretched mesh is the grown one, moved up, with correct normals") {
	const PlantForm form = grow_tulip(1);
	const FormPlan plan = plan_form(form, measure_form(form), vertex_budget(40));
	const BuiltForm grown = build(form, plan);
	const BuiltForm tall = build(form, plan, 1.5f * form.height);
	for (size_t i = 0; i < grown.positions.size(); i++) {
		CHECK(std::abs(tall.positions[i].y - 1.5f * grown.positions[i].y) < 1e-6f);
		CHECK(tall.positions[i].x == grown.positions[i].x);
		CHECK(tall.custom0[i] == grown.custom0[i]);
		CHECK(std::abs(tall.custom1[i].y - 1.5f * grown.custom1[i].y) < 1e-6f); // Pivots.
		CHECK(std::abs(tall.custom2[i].y - 1.5f * grown.custom2[i].y) < 1e-6f); // Offsets from the midrib.
	}
	check_sound(tall);
}

TEST_CASE("a colour deviation tints each part separately") {
	const PlantForm form = grow_grass(1);
	const FormPlan plan = plan_form(form, measure_form(form), vertex_budget(40));
	MeshOptions options;
	options.color_deviation = 1.0f;
	const BuiltForm plain = build(form, plan);
	const BuiltForm tinted = build(form, plan, 0.0f, options);
	float min = 2.0f;
	float max = 0.0f;
	for (size_t i = 0; i < plain.colors.size(); i++) {
		min = std::min(min, tinted.colors[i].y / plain.colors[i].y);
		max = std::max(max, tinted.colors[i].y / plain.colors[i].y);
	}
	CHECK(min < 0.9f);
	CHECK(min >= 0.749f);
	CHECK(max > 1.1f);
}

namespace {

/// White flowers on green stalks, above this number of leaves.
PlantForm grow_umbel(int leaves = 0) {
	Growth growth(0.3f, 1);
	Part stem, stalk, flower;
	stem.kind = stalk.kind = PartKind::axis;
	stem.length_min = stem.length_max = 0.5f;
	stem.width = 0.003f;
	stalk.length_min = stalk.length_max = 0.07f;
	stalk.width = 0.001f;
	stalk.colors.base = stalk.colors.tip = glm::vec4(0.4f, 0.6f, 0.3f, 1.0f);
	flower.kind = PartKind::bead;
	flower.length_min = flower.length_max = flower.width = 0.01f;
	flower.colors.base = flower.colors.tip = glm::vec4(0.9f, 0.9f, 0.9f, 1.0f);
	int kinds[3] = {};
	REQUIRE(growth.add_kind(stem, kinds[0]) == "");
	REQUIRE(growth.add_kind(stalk, kinds[1]) == "");
	REQUIRE(growth.add_kind(flower, kinds[2]) == "");
	Arrangement ground, stalks, tips;
	ground.layout = Layout::ground;
	stalks.count_min = stalks.count_max = 40;
	stalks.from = 0.87f;
	stalks.angle = { 1.0f, 0.1f };
	stalks.scale = { 1.0f, 0.32f };
	tips.from = 1.0f;
	std::vector<int> on_ground, on_stem, on_stalks;
	REQUIRE(growth.arrange(kinds[0], ground, { ON_GROUND }, on_ground) == "");
	REQUIRE(growth.arrange(kinds[1], stalks, on_ground, on_stem) == "");
	REQUIRE(growth.arrange(kinds[2], tips, on_stem, on_stalks) == "");
	if (leaves > 0) {
		Part leaf;
		leaf.length_min = leaf.length_max = 0.25f;
		leaf.width = 0.02f;
		leaf.colors.base = leaf.colors.tip = stalk.colors.tip;
		Arrangement tuft;
		int kind = 0;
		tuft.layout = Layout::ground;
		tuft.count_min = tuft.count_max = leaves;
		tuft.tilt = { 0.3f, 0.9f };
		std::vector<int> on_tuft;
		REQUIRE(growth.add_kind(leaf, kind) == "");
		REQUIRE(growth.arrange(kind, tuft, { ON_GROUND }, on_tuft) == "");
	}
	return growth.finish();
}

} // namespace

TEST_CASE("the body of an umbel is flat, widest at its flowers, and green below") {
	const PlantForm form = grow_umbel();
	const FormMeasure measure = measure_form(form);
	const std::vector<FormBody> bodies = make_bodies(form, measure, plan_form(form, measure, 22));
	REQUIRE(bodies.size() == 1);
	const std::vector<FormBody::Ring> &rings = bodies[0].rings;
	REQUIRE(rings.size() == 3);
	CHECK(rings[1].along - rings[0].along > 2.0f * (rings[2].along - rings[1].along));
	CHECK(2.0f * rings[1].radius > rings[2].along - rings[0].along);
	CHECK(rings[1].color.x > rings[0].color.x + 0.1f);
	CHECK(rings[2].color == rings[1].color);
}

TEST_CASE("flowers of coarse plants are not tinted by the colour of their leaves") {
	const BuiltForm mesh = build_level(grow_umbel(3), 1);
	glm::vec4 brightest(0.0f);
	for (const glm::vec4 &color : mesh.colors) {
		brightest = color.x > brightest.x ? color : brightest;
	}
	CHECK(brightest.x > 0.92f * brightest.y);
	CHECK(brightest.z > 0.88f * brightest.y);
}

TEST_CASE("meshes of parts are the same on every platform") {
	const uint64_t goldens[3][3] = { { 0x2a43de97d06fb04full, 0xb091265febaf0142ull, 0x885dbd4f667bd5ull },
		{ 0x794200e86f1be483ull, 0x850e97cebfe8eb5aull, 0xff03c6728127412full },
		{ 0x53391ab7045ab109ull, 0x7699a7db1e00ed00ull, 0x1f87cf2d347b0a32ull } };
	const int lods[3] = { 12, 3, 1 };
	for (int species = 0; species < 3; species++) {
		const PlantForm form = SPECIES[species](5);
		for (int level = 0; level < 3; level++) {
			CHECK(build_level(form, lods[level]).hash() == goldens[species][level]);
		}
	}
}

// Building the meshes of plants.

#include "form/growth.hpp"
#include "mesh/form_mesh.hpp"
#include "mesh/plant_mesh.hpp"
#include "motion/part_bend.hpp"
#include "plant/base_shape.hpp"
#include "report.hpp"
#include "stem/stem_bones.hpp"
#include "stem/stem_recipe.hpp"

using namespace undergrowth;

namespace {

constexpr int MESHES = 500;
constexpr int RING_POINTS = 16;
constexpr int LOD = 16;

/// A mesh with all attributes, in memory that is taken once.
class MeshRoom {
public:
	explicit MeshRoom(const MeshCounts &counts) :
			positions(size(counts.vertices)),
			normals(size(counts.vertices)),
			colors(size(counts.vertices)),
			uvs(size(counts.vertices)),
			bones(4 * size(counts.vertices)),
			weights(4 * size(counts.vertices)),
			indices(size(counts.indices)) {}

	MeshBuffers buffers() {
		return { positions.data(), normals.data(), colors.data(), uvs.data(), bones.data(), weights.data(),
			indices.data() };
	}

private:
	std::vector<glm::vec3> positions;
	std::vector<glm::vec3> normals;
	std::vector<glm::vec4> colors;
	std::vector<glm::vec2> uvs;
	std::vector<int32_t> bones;
	std::vector<float> weights;
	std::vector<int32_t> indices;

	static std::size_t size(int count) { return static_cast<std::size_t>(count); }
};

/// A daisy: rosette, stems with leaves, and heads of a disc and rays.
PlantForm grow_daisy() {
	Growth growth(0.5f, 4);
	const auto add = [&](const Part &part, Layout layout, int count, float radius, float angle,
							 const std::vector<int> &on) {
		int kind = 0;
		std::vector<int> handles;
		Arrangement arrangement;
		arrangement.layout = layout;
		arrangement.count_min = arrangement.count_max = count;
		arrangement.radius = radius;
		arrangement.angle = { angle, angle };
		arrangement.tilt = { 0.1f, angle };
		growth.add_kind(part, kind);
		growth.arrange(kind, arrangement, on, handles);
		return handles;
	};
	Part leaf;
	leaf.length_min = leaf.length_max = 0.06f;
	leaf.blade.teeth = 5;
	Part ray;
	ray.length_min = ray.length_max = 0.016f;
	ray.width = 0.0045f;
	Part stem;
	stem.kind = PartKind::axis;
	stem.length_min = stem.length_max = 0.5f;
	stem.width = 0.003f;
	stem.axis.tip_diameter = 0.002f;
	Part floret;
	floret.kind = PartKind::bead;
	floret.length_min = floret.length_max = 0.003f;
	floret.width = 0.001f;
	add(leaf, Layout::ground, 8, 0.01f, 1.0f, { ON_GROUND });
	const std::vector<int> stems = add(stem, Layout::ground, 2, 0.01f, 0.2f, { ON_GROUND });
	add(leaf, Layout::along, 9, 0.0f, 0.6f, stems);
	add(floret, Layout::disc, 130, 0.0075f, 0.0f, stems);
	add(ray, Layout::whorl, 22, 0.007f, 1.4f, stems);
	return growth.finish();
}

/// A mesh of parts with all attributes, in memory that is taken once.
struct FormRoom {
	std::vector<glm::vec3> positions, normals;
	std::vector<glm::vec4> tangents, colors, custom0, custom1, custom2;
	std::vector<glm::vec2> uvs;
	std::vector<int32_t> bones, indices;
	std::vector<float> weights, stem_places;

	explicit FormRoom(const MeshCounts &counts) {
		const std::size_t n = static_cast<std::size_t>(counts.vertices);
		for (auto *points : { &positions, &normals }) {
			points->resize(n);
		}
		for (auto *values : { &tangents, &colors, &custom0, &custom1, &custom2 }) {
			values->resize(n);
		}
		uvs.resize(n);
		bones.resize(4 * n);
		weights.resize(4 * n);
		stem_places.resize(n);
		indices.resize(static_cast<std::size_t>(counts.indices));
	}
	FormBuffers buffers() {
		return { positions.data(), normals.data(), tangents.data(), colors.data(), uvs.data(), custom0.data(),
			custom1.data(), custom2.data(), bones.data(), weights.data(), indices.data(), stem_places.data() };
	}
};

/// A daisy of parts: measured once for all levels; then planned, written and matched at some.
void time_forms(Report &report) {
	const PlantForm form = grow_daisy();
	FormMeasure measure;
	report.row("daisy_measured", 1, 1, median_ms([&] { measure = measure_form(form); }), SimdLevel::baseline);
	for (const int lod : { 12, 6, 3 }) {
		FormPlan plan = plan_form(form, measure, vertex_budget(lod));
		FormRoom room(plan.counts);
		const auto build = [&] { build_form_mesh(form, measure, plan, {}, {}, form.height, room.buffers()); };
		const std::string vertices = member("vertices", plan.counts.vertices);
		report.row("daisy_matched", 1, 1, median_ms(build), SimdLevel::baseline, vertices);
		plan.is_cut = false; // What is written of it, without looking whether it shows the same.
		report.row("daisy_written", 1, 1, median_ms(build), SimdLevel::baseline, vertices);
		const auto decide = [&] { plan_form(form, measure, vertex_budget(lod)); };
		report.row("daisy_planned", 1, 1, median_ms(decide), SimdLevel::baseline, vertices);
	}
}

/// What a species' stem comes to, once for all its plants.
void time_stems(Report &report) {
	StemRecipe recipe;
	recipe.beam.modes = MAX_STEM_MODES;
	SolvedStem solved;
	report.row("stem_constants", 1, 1, median_ms([&] { solved = solve_recipe(recipe); }), SimdLevel::baseline);
}

/// What a skeleton shows of a plant in each frame: its stem alone, and with one chain of a branch, a twig on it and a
/// leaf on that.
void time_orders(Report &report) {
	constexpr int PLANTS = 10000;
	StemRecipe recipe;
	const SolvedStem solved = solve_recipe(recipe);
	StemMotion motion;
	motion.rate = { 0.1f, -0.1f };
	motion.air = 4.0f;
	CarrierSwing chain[1 + MAX_INNER_SWINGS];
	for (int k = 0; k <= MAX_INNER_SWINGS; k++) {
		chain[k].weight = 0.6f;
		chain[k].swing.frequency = 1.4f + 0.8f * static_cast<float>(k);
		chain[k].swing.side = { 1.0f, 0.0f };
	}
	float sum = 0.0f;
	const auto time = [&](const char *name, int orders) {
		const double run = median_ms([&] {
			for (int i = 0; i < PLANTS; i++) {
				motion.bend = { 1e-5f * static_cast<float>(i), 0.02f };
				const PosedStem posed(*solved.in_air, 1.0f, motion);
				StemLink links[MAX_STEM_JOINTS];
				sum += stem_links(*solved.in_air, posed.amplitudes, links).x + links[0].turn.x;
				for (int k = 0; k < orders; k++) {
					sum += part_bend(chain[k].swing, motion, chain, k).x;
				}
			}
		});
		report.row(name, PLANTS, 1, run, SimdLevel::baseline, member("sum", static_cast<double>(sum)));
	};
	time("stem_shown", 0);
	time("three_orders_shown", 1 + MAX_INNER_SWINGS);
}

} // namespace

void undergrowth::time_meshes(Report &report) {
	time_forms(report);
	time_stems(report);
	time_orders(report);
	const CrossSection section = make_cross_section(circle_ring(RING_POINTS));
	const std::vector<float> widths(LOD + 1, 0.5f);
	const std::vector<glm::vec4> colors(LOD + 1, glm::vec4(0.2f, 0.8f, 0.2f, 1.0f));
	PlantSample sample;
	sample.cross_section = &section;
	sample.widths = widths.data();
	sample.colors = colors.data();
	sample.lod = LOD;
	MeshRoom room(count_mesh(RING_POINTS, LOD, Shading::smooth));
	const MeshBuffers buffers = room.buffers();
	const double run = median_ms([&] {
		for (int i = 0; i < MESHES; i++) {
			build_mesh(sample, MeshOptions{}, buffers);
		}
	});
	report.row("mesh", MESHES, 1, run, SimdLevel::baseline);
}

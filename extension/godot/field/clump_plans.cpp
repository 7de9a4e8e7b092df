// Plans the multimeshes of a field: which plants each holds, where they stand and where their poses are.

#include "field/field_view.hpp"

#include "convert.hpp"
#include "field/plant_transforms.hpp"

#include <algorithm>

using namespace godot;

namespace undergrowth {

static constexpr int TRANSFORM_FLOATS = 12; // 3x4, row by row.
static constexpr int COLOR_FLOATS = 4;
static constexpr int CUSTOM_FLOATS = 4;
// Compatibility keeps custom data in half floats, which count exactly from -2048 to 2048.
static constexpr int HALVES_COUNT_FROM = -2048;

static ClumpPlace place_of(const FieldStyle &style, int level, const PlantBlock &block) {
	return { block.is_added, level, wider_tile(block.tile, style.levels[size_t(level)].tile_factor) };
}

static void write_transform(float *to, const Transform3D &transform) {
	for (int row = 0; row < 3; row++) {
		const Vector3 &axes = transform.basis.rows[row];
		for (const float number : { axes.x, axes.y, axes.z, transform.origin[row] }) {
			*to++ = number;
		}
	}
}

static AABB reach(const FieldLook &look, const PlacedPlant &plant) {
	const float radius = look.reach_of(plant);
	const Vector3 root = to_godot(plant.root);
	return AABB(root - Vector3(radius, radius, radius), 2.0f * Vector3(radius, radius, radius));
}

// Appends a plant to a plan whose buffer has room for it. `texel`: where the shader finds its pose.
static void add_plant(ClumpPlan &plan, const FieldLook &look, const PlacedPlant &plant, const PoseTexels &texel) {
	const float mesh_height = look.variants[size_t(plan.group)].height;
	float *to = plan.buffer.ptrw() + int64_t(plan.count) * plan.stride;
	write_transform(to, drawn_transform(plant));
	std::fill(to + TRANSFORM_FLOATS, to + plan.stride, 1.0f); // White, where there is a colour.
	float *custom = to + plan.stride - CUSTOM_FLOATS;
	custom[0] = float(texel.first + HALVES_COUNT_FROM);
	custom[1] = float(texel.layer + HALVES_COUNT_FROM);
	custom[2] = plant.turn;
	custom[3] = look.height_of(plant) / mesh_height;
	const AABB box = reach(look, plant);
	plan.box = plan.count == 0 ? box : plan.box.merge(box);
	plan.count++;
}

static int group_of(const FieldLook &look, const PlantBlock &block, int slot, int groups) {
	return int(block.plants.variant[size_t(slot)] % look.variants.size()) % groups;
}

using PlansByMesh = std::map<std::tuple<ClumpPlace, int, int>, ClumpPlan>; // Place, species, group.

static void add_block(const FieldStyle &style, const DrawnBlock &drawn, int level, PlansByMesh &plans) {
	const PlantBlock &block = *drawn.block;
	const ClumpPlace place = place_of(style, level, block);
	const FieldLook &look = style.looks[size_t(block.species)];
	const int groups = int(look.meshes[size_t(level)].size());
	std::vector<int> counts(size_t(groups), 0);
	for (int slot = 0; slot < block.size(); slot++) {
		counts[size_t(group_of(look, block, slot, groups))] += block.is_gone(slot) ? 0 : 1;
	}
	std::vector<ClumpPlan *> by_group(size_t(groups), nullptr);
	for (int group = 0; group < groups; group++) {
		if (counts[size_t(group)] > 0) {
			ClumpPlan &plan = plans[{ place, block.species, group }];
			plan.place = place;
			plan.species = block.species;
			plan.group = group;
			plan.stride = TRANSFORM_FLOATS + CUSTOM_FLOATS + (style.needs_colors ? COLOR_FLOATS : 0);
			plan.buffer.resize(int64_t(plan.count + counts[size_t(group)]) * plan.stride);
			by_group[size_t(group)] = &plan;
		}
	}
	for (int slot = 0; slot < block.size(); slot++) {
		if (!block.is_gone(slot)) {
			ClumpPlan &plan = *by_group[size_t(group_of(look, block, slot, groups))];
			add_plant(plan, look, block.plants.plant(slot), { drawn.texels.layer, drawn.texels.first + slot });
		}
	}
}

std::vector<ClumpPlan> plan_level(const FieldStyle &style, const std::vector<DrawnBlock> &blocks, int level) {
	PlansByMesh by_mesh;
	for (const DrawnBlock &drawn : blocks) {
		add_block(style, drawn, level, by_mesh);
	}
	std::vector<ClumpPlan> plans;
	for (auto &[mesh, plan] : by_mesh) {
		plans.push_back(std::move(plan));
	}
	return plans;
}

std::vector<ClumpPlan> plan_clumps(const FieldStyle &style, const std::vector<DrawnBlock> &blocks) {
	std::vector<ClumpPlan> plans;
	for (int level = 0; level < int(style.levels.size()); level++) {
		for (ClumpPlan &plan : plan_level(style, blocks, level)) {
			plans.push_back(std::move(plan));
		}
	}
	return plans;
}

} // namespace undergrowth

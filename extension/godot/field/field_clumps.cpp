// Plans the multimeshes of a field: which plants each holds, where they stand and where their bends are.

#include "field/field_drawing.hpp"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr int TRANSFORM_FLOATS = 12; // 3x4, row by row.
static constexpr int COLOR_FLOATS = 4;
static constexpr int CUSTOM_FLOATS = 4;
static constexpr int HALVES_COUNT_TO = 2048; // Compatibility keeps custom data in half floats, exact up to here.

ClumpPlace FieldDrawing::place_of(const FieldStyle &style, int level, int column, int row) {
	const int factor = style.levels[size_t(level)].chunk_factor;
	const auto divide = [factor](int count) { return count >= 0 ? count / factor : -((-count + factor - 1) / factor); };
	return { level, divide(column), divide(row) };
}

// Where the shader finds a plant's bend.
static void write_place(float *to, int page, int index) {
	to[0] = float(index % HALVES_COUNT_TO);
	to[1] = float(2 * page + index / HALVES_COUNT_TO);
}

static void write_transform(float *to, const PlacedPlant &plant) {
	const float c = plant.scale * std::cos(plant.turn);
	const float s = plant.scale * std::sin(plant.turn);
	const float rows[12] = { c, 0.0f, s, plant.root.x, 0.0f, plant.scale, 0.0f, plant.root.y, -s, 0.0f, c,
		plant.root.z };
	std::copy(rows, rows + 12, to);
}

// The plant's mesh moves no vertex farther from its root than it is at rest.
static AABB reach(const FieldLook &look, const PlacedPlant &plant) {
	const float height = look.length_of(plant);
	const float width = look.width * plant.scale;
	const float radius = std::sqrt(height * height + width * width);
	const Vector3 root(plant.root.x, plant.root.y, plant.root.z);
	return AABB(root - Vector3(radius, radius, radius), 2.0f * Vector3(radius, radius, radius));
}

// Appends plants [begin, end) to a plan, but for those that are gone.
static void add_range(ClumpPlan &plan, const FieldLook &look, const FieldPatch &patch, const ChunkRange &range) {
	const float mesh_height = look.variants[size_t(plan.group)].height;
	plan.buffer.resize(int64_t(plan.count + range.end - range.begin) * plan.stride);
	float *to = plan.buffer.ptrw() + int64_t(plan.count) * plan.stride;
	for (int i = range.begin; i < range.end; i++) {
		if (patch.places[size_t(i)] == FieldPatch::GONE) {
			continue;
		}
		const PlacedPlant plant = patch.plants.plant(i);
		write_transform(to, plant);
		std::fill(to + TRANSFORM_FLOATS, to + plan.stride, 1.0f); // White, where there is a colour.
		float *custom = to + plan.stride - CUSTOM_FLOATS;
		write_place(custom, patch.page(i), patch.index(i));
		custom[2] = plant.turn;
		custom[3] = look.variants[size_t(plant.variant)].height * plant.height / mesh_height;
		const AABB box = reach(look, plant);
		plan.box = plan.count == 0 ? box : plan.box.merge(box);
		plan.count++;
		to += plan.stride;
	}
}

// The plants of chunks [begin, end), which are one place, cut into a plan for each mesh.
static void plan_chunks(const FieldStyle &style, const FieldPatch &patch, const ClumpPlace &place,
		const std::vector<const FieldChunk *> &chunks, std::vector<ClumpPlan> &plans) {
	std::map<std::pair<int, int>, ClumpPlan> by_mesh;
	for (const FieldChunk *chunk : chunks) {
		for (int i = chunk->first_range; i < chunk->last_range; i++) {
			const ChunkRange &range = patch.chunks.ranges[size_t(i)];
			const FieldLook &look = style.looks[range.species];
			const int group = range.variant % int(look.meshes[size_t(place.level)].size());
			ClumpPlan &plan = by_mesh[{ range.species, group }];
			plan.place = place;
			plan.species = range.species;
			plan.group = group;
			plan.stride = TRANSFORM_FLOATS + CUSTOM_FLOATS + (style.needs_colors ? COLOR_FLOATS : 0);
			add_range(plan, look, patch, range);
		}
	}
	for (auto &[mesh, plan] : by_mesh) {
		if (plan.count > 0) {
			plan.buffer.resize(int64_t(plan.count) * plan.stride);
			plans.push_back(std::move(plan));
		}
	}
}

std::vector<ClumpPlan> FieldDrawing::plan(const FieldStyle &style, const FieldPatch &patch) {
	std::vector<ClumpPlan> plans;
	for (int level = 0; level < int(style.levels.size()); level++) {
		std::map<ClumpPlace, std::vector<const FieldChunk *>> places;
		for (const FieldChunk &chunk : patch.chunks.chunks) {
			places[place_of(style, level, chunk.column, chunk.row)].push_back(&chunk);
		}
		for (const auto &[place, chunks] : places) {
			plan_chunks(style, patch, place, chunks, plans);
		}
	}
	return plans;
}

std::vector<ClumpPlan> FieldDrawing::plan_one(
		const FieldStyle &style, const FieldPatch &patch, const ClumpPlace &place) {
	std::vector<const FieldChunk *> members;
	for (const FieldChunk &chunk : patch.chunks.chunks) {
		const ClumpPlace own = place_of(style, place.level, chunk.column, chunk.row);
		if (own.column == place.column && own.row == place.row) {
			members.push_back(&chunk);
		}
	}
	std::vector<ClumpPlan> plans;
	plan_chunks(style, patch, place, members, plans);
	return plans;
}

} // namespace undergrowth

// Plans the multimeshes of a field: which plants each holds, where they stand and where their poses are.

#include "field/field_view.hpp"

#include "convert.hpp"
#include "field/plant_transforms.hpp"
#include "mesh/form_plan.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace godot;

namespace undergrowth {

static constexpr int TRANSFORM_FLOATS = 12; // 3x4, row by row.
static constexpr int COLOR_FLOATS = 4;
static constexpr int CUSTOM_FLOATS = 4;
// Compatibility keeps custom data in half floats, which count exactly from -2048 to 2048.
static constexpr int HALVES_COUNT_FROM = -2048;
// Of plants of parts only the parts are drawn wider, not the whole.
static constexpr float PARTS_WIDENING = 1.25f;

// What a draw costs in vertices: so many that nobody sees may be drawn to spare one.
static constexpr float VERTICES_OF_DRAW = 3000.0f;
static constexpr int MOST_SQUARE_FACTOR = 8;

// How wide the squares of a species are: so many tiles, or so many squares along a tile's side; one of the two is 1.
struct Squares {
	int factor = 1;
	int cuts = 1;
};

// The level's, and wider ones for sparse species, of which squares hold a few plants each. Squares of twice the side
// are a quarter as many, and those at the level's end reach farther beyond it; of both, what saves more.
static Squares squares_of(const FieldStyle &style, int level, const FieldLook &look, float plants_in_tile) {
	const FieldLevel &seen = style.levels[size_t(level)];
	Squares squares = { style.is_of_tiles ? 1 : seen.tile_factor, seen.tile_cuts };
	const float end = seen.end > 0.0f ? seen.end : 2.0f * seen.begin;
	const float meshes = float(look.meshes[size_t(level)].size());
	const float vertices = plants_in_tile / meshes * float(vertex_budget(look.segments_at(seen)));
	while (squares.cuts > 1 || (squares.factor < MOST_SQUARE_FACTOR && !style.is_of_tiles)) {
		const float tiles = float(squares.factor) / float(squares.cuts); // Along a side.
		const float side = tiles * style.tile_size;
		if (side * 2.0f > end || 2.0f * vertices * tiles * tiles * side > VERTICES_OF_DRAW * end) {
			break;
		}
		squares.cuts > 1 ? squares.cuts /= 2 : squares.factor *= 2;
	}
	return squares;
}

// By species; of those that were filled, for the places of others are asked for by tiles.
static std::vector<Squares> all_squares(const FieldStyle &style, int level, const std::vector<DrawnBlock> &blocks) {
	std::vector<float> plants(style.looks.size(), 0.0f), tiles(style.looks.size(), 0.0f);
	for (const DrawnBlock &drawn : blocks) {
		plants[size_t(drawn.block->species)] += float(drawn.block->size());
		tiles[size_t(drawn.block->species)] += 1.0f;
	}
	std::vector<Squares> squares;
	for (size_t i = 0; i < style.looks.size(); i++) {
		squares.push_back(squares_of(style, level, style.looks[i], plants[i] / std::max(tiles[i], 1.0f)));
	}
	return squares;
}

// The square of a level that holds a root; where squares are parts of a tile, one of the block's own tile.
static ClumpPlace place_of(
		const FieldStyle &style, int level, const DrawnBlock &drawn, const Squares &squares, const glm::vec3 &root) {
	const PlantBlock &block = *drawn.block;
	if (drawn.newcomers >= 0) {
		return { false, level, 1, block.tile, drawn.newcomers };
	}
	if (squares.cuts == 1) {
		return { block.is_added, level, squares.factor, wider_tile(block.tile, squares.factor) };
	}
	const auto part = [&](float place, int tile) {
		const float way = place / style.tile_size - float(tile);
		return std::clamp(int(way * float(squares.cuts)), 0, squares.cuts - 1);
	};
	const int number = part(root.z, block.tile.row) * squares.cuts + part(root.x, block.tile.column);
	return { block.is_added, level, 1, block.tile, -1, number };
}

static void write_transform(float *to, const Transform3D &transform) {
	for (int row = 0; row < 3; row++) {
		const Vector3 &axes = transform.basis.rows[row];
		for (const float number : { axes.x, axes.y, axes.z, transform.origin[row] }) {
			*to++ = number;
		}
	}
}

static AABB reach(const FieldLook &look, const PlacedPlant &plant, float widening) {
	const float radius = look.reach_of(plant, widening);
	const Vector3 root = to_godot(plant.root);
	return AABB(root - Vector3(radius, radius, radius), 2.0f * Vector3(radius, radius, radius));
}

// A plant in the making of a plan.
struct Member {
	float rank;
	const DrawnBlock *block;
	int slot;

	bool operator<(const Member &other) const { return rank < other.rank; }
};

using MembersByMesh = std::map<std::tuple<ClumpPlace, int, int>, std::vector<Member>>; // Place, species, group.

// Appends a plant to a plan whose buffer has room for it.
static void add_plant(const FieldStyle &style, const Member &member, ClumpPlan &plan) {
	const FieldLook &look = style.looks[size_t(plan.species)];
	const PlacedPlant plant = member.block->block->plants.plant(member.slot);
	float *to = plan.buffer.ptrw() + int64_t(plan.count) * plan.stride;
	write_transform(to, drawn_transform(plant));
	std::fill(to + TRANSFORM_FLOATS, to + plan.stride, 1.0f); // White, where there is a colour.
	float *custom = to + plan.stride - CUSTOM_FLOATS;
	custom[0] = float(member.block->texels.first + member.slot + HALVES_COUNT_FROM);
	custom[1] = float(member.block->texels.layer + HALVES_COUNT_FROM);
	custom[2] = member.rank;
	custom[3] = look.height_of(plant) / look.variants[size_t(plan.group)].height;
	const AABB box = reach(look, plant, look.has_parts() ? PARTS_WIDENING : MOST_WIDENING);
	const AABB root(to_godot(plant.root), Vector3());
	plan.box = plan.count == 0 ? box : plan.box.merge(box);
	plan.roots = plan.count == 0 ? root : plan.roots.merge(root);
	plan.count++;
	plan.kept[size_t(std::ceil(member.rank * RANK_STEPS))]++;
}

// By rank, so that whoever is left away far from the eye is at the end.
static ClumpPlan make_plan(const FieldStyle &style, const MembersByMesh::key_type &key, std::vector<Member> &members) {
	ClumpPlan plan;
	std::tie(plan.place, plan.species, plan.group) = key;
	plan.stride = TRANSFORM_FLOATS + CUSTOM_FLOATS + (style.needs_colors ? COLOR_FLOATS : 0);
	plan.buffer.resize(int64_t(members.size()) * plan.stride);
	std::stable_sort(members.begin(), members.end());
	for (const Member &member : members) {
		add_plant(style, member, plan);
	}
	std::partial_sum(plan.kept.begin(), plan.kept.end(), plan.kept.begin());
	return plan;
}

static float rank_of(const PlantBlock &block, int slot) {
	if (block.is_added) {
		return plant_rank(block.ids[size_t(slot)]);
	}
	const glm::vec3 root = block.root(slot);
	return plant_rank(filled_plant_id(root.x, root.z, block.spacing));
}

// Of all plants of a block, the same at all levels.
static std::vector<float> all_ranks(const PlantBlock &block) {
	std::vector<float> ranks(size_t(block.size()));
	for (int slot = 0; slot < block.size(); slot++) {
		ranks[size_t(slot)] = rank_of(block, slot);
	}
	return ranks;
}

// A block's squares are few: each is looked up once.
static void add_block(const FieldStyle &style, const DrawnBlock &drawn, const std::vector<float> &ranks, int level,
		const std::vector<Squares> &squares, MembersByMesh &members) {
	const PlantBlock &block = *drawn.block;
	const FieldLook &look = style.looks[size_t(block.species)];
	const int groups = int(look.meshes[size_t(level)].size());
	const FieldLevel &seen = style.levels[size_t(level)];
	const Squares own = block.is_added ? Squares{ seen.tile_factor, seen.tile_cuts } : squares[size_t(block.species)];
	std::vector<std::vector<Member> *> found(size_t(own.cuts * own.cuts * groups), nullptr);
	for (int slot = 0; slot < block.size(); slot++) {
		if (block.is_gone(slot)) {
			continue;
		}
		const int group = int(block.plants.variant[size_t(slot)] % look.variants.size()) % groups;
		const ClumpPlace place = place_of(style, level, drawn, own, block.root(slot));
		std::vector<Member> *&there = found[size_t(std::max(place.part, 0) * groups + group)];
		if (!there) {
			there = &members[{ place, block.species, group }];
		}
		there->push_back({ ranks[size_t(slot)], &drawn, slot });
	}
}

using Ranks = std::vector<std::vector<float>>; // By block.

static Ranks ranks_of(const std::vector<DrawnBlock> &blocks) {
	Ranks ranks;
	for (const DrawnBlock &block : blocks) {
		ranks.push_back(all_ranks(*block.block));
	}
	return ranks;
}

static std::vector<ClumpPlan> plan_level(
		const FieldStyle &style, const std::vector<DrawnBlock> &blocks, const Ranks &ranks, int level) {
	MembersByMesh by_mesh;
	const std::vector<Squares> squares = all_squares(style, level, blocks);
	for (size_t i = 0; i < blocks.size(); i++) {
		add_block(style, blocks[i], ranks[i], level, squares, by_mesh);
	}
	std::vector<ClumpPlan> plans;
	for (auto &[mesh, members] : by_mesh) {
		plans.push_back(make_plan(style, mesh, members));
	}
	return plans;
}

std::vector<ClumpPlan> plan_level(const FieldStyle &style, const std::vector<DrawnBlock> &blocks, int level) {
	return plan_level(style, blocks, ranks_of(blocks), level);
}

std::vector<ClumpPlan> plan_clumps(const FieldStyle &style, const std::vector<DrawnBlock> &blocks) {
	std::vector<ClumpPlan> plans;
	const Ranks ranks = ranks_of(blocks);
	for (int level = 0; level < int(style.levels.size()); level++) {
		for (ClumpPlan &plan : plan_level(style, blocks, ranks, level)) {
			plans.push_back(std::move(plan));
		}
	}
	return plans;
}

} // namespace undergrowth

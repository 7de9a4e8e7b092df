// Plans the multimeshes of a field: which plants each holds, where they stand and where their poses are.

#include "field/field_view.hpp"

#include "convert.hpp"
#include "field/ranked_plants.hpp"
#include "mesh/form_plan.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace godot;

namespace undergrowth {

static constexpr int TRANSFORM_FLOATS = 12; // 3x4, row by row.
static constexpr int COLOR_FLOATS = 4;
static constexpr int CUSTOM_FLOATS = 4;

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

// Which multimeshes a level has, and which of them each plant is in.
struct Division {
	std::map<std::tuple<ClumpPlace, int, int>, int> numbers; // By place, species, group.
	std::vector<int> counts;
	std::vector<int> of_plants;
};

static Division divide(const FieldStyle &style, const std::vector<DrawnBlock> &blocks,
		const std::vector<RankedPlant> &plants, int level) {
	const FieldLevel &seen = style.levels[size_t(level)];
	const std::vector<Squares> squares = all_squares(style, level, blocks);
	std::vector<std::vector<int>> found(blocks.size()); // A block's squares are few: each is looked up once.
	Division division;
	division.of_plants.reserve(plants.size());
	for (const RankedPlant &plant : plants) {
		const DrawnBlock &drawn = blocks[size_t(plant.block)];
		const int species = drawn.block->species;
		const int groups = int(style.looks[size_t(species)].meshes[size_t(level)].size());
		const Squares own =
				drawn.block->is_added ? Squares{ seen.tile_factor, seen.tile_cuts } : squares[size_t(species)];
		const ClumpPlace place = place_of(style, level, drawn, own, to_glm(plant.transform.origin));
		std::vector<int> &of_block = found[size_t(plant.block)];
		of_block.resize(size_t(own.cuts * own.cuts * groups), -1);
		const int group = plant.variant % groups;
		int &number = of_block[size_t(std::max(place.part, 0) * groups + group)];
		if (number < 0) {
			const int next = int(division.numbers.size());
			number = division.numbers.try_emplace({ place, species, group }, next).first->second;
			division.counts.resize(division.numbers.size(), 0);
		}
		division.counts[size_t(number)]++;
		division.of_plants.push_back(number);
	}
	return division;
}

static float *write_transform(float *to, const Transform3D &transform) {
	for (int row = 0; row < 3; row++) {
		const Vector3 &axes = transform.basis.rows[row];
		for (const float number : { axes.x, axes.y, axes.z, transform.origin[row] }) {
			*to++ = number;
		}
	}
	return to;
}

// Until the plan is done, its boxes have their highest corners in place of their sizes.
static void widen(ClumpPlan &plan, const Vector3 &root, float reach) {
	const Vector3 around(reach, reach, reach);
	const bool is_first = plan.count++ == 0;
	plan.roots.position = is_first ? root : plan.roots.position.min(root);
	plan.roots.size = is_first ? root : plan.roots.size.max(root);
	plan.box.position = is_first ? root - around : plan.box.position.min(root - around);
	plan.box.size = is_first ? root + around : plan.box.size.max(root + around);
}

// Appends a plant to a plan, of which `to` is the buffer's end so far.
static void add_plant(const FieldStyle &style, const RankedPlant &plant, ClumpPlan &plan, float *&to) {
	to = write_transform(to, plant.transform);
	if (style.needs_colors) {
		to = std::fill_n(to, COLOR_FLOATS, 1.0f); // White.
	}
	*to++ = plant.texel;
	*to++ = plant.layer;
	*to++ = plant.rank;
	*to++ = plant.height / style.looks[size_t(plan.species)].variants[size_t(plan.group)].height;
	widen(plan, plant.transform.origin, plant.reach);
	plan.kept[size_t(std::ceil(plant.rank * RANK_STEPS))]++;
}

// Plants come by rank, so that whoever is left away far from the eye is at the end.
static std::vector<ClumpPlan> plan_level(const FieldStyle &style, const std::vector<DrawnBlock> &blocks,
		const std::vector<RankedPlant> &plants, int level) {
	const Division division = divide(style, blocks, plants, level);
	std::vector<ClumpPlan> plans(division.counts.size());
	std::vector<float *> ends(plans.size());
	std::vector<size_t> places(plans.size());
	size_t next = 0;
	for (const auto &[key, number] : division.numbers) {
		ClumpPlan &plan = plans[next];
		std::tie(plan.place, plan.species, plan.group) = key;
		plan.stride = TRANSFORM_FLOATS + CUSTOM_FLOATS + (style.needs_colors ? COLOR_FLOATS : 0);
		plan.buffer.resize(int64_t(division.counts[size_t(number)]) * plan.stride);
		ends[next] = plan.buffer.ptrw();
		places[size_t(number)] = next++;
	}
	for (size_t i = 0; i < plants.size(); i++) {
		const size_t place = places[size_t(division.of_plants[i])];
		add_plant(style, plants[i], plans[place], ends[place]);
	}
	for (ClumpPlan &plan : plans) {
		plan.roots.size -= plan.roots.position;
		plan.box.size -= plan.box.position;
		std::partial_sum(plan.kept.begin(), plan.kept.end(), plan.kept.begin());
	}
	return plans;
}

std::vector<ClumpPlan> plan_level(const FieldStyle &style, const std::vector<DrawnBlock> &blocks, int level) {
	return plan_level(style, blocks, rank_plants(style, blocks), level);
}

std::vector<ClumpPlan> plan_clumps(const FieldStyle &style, const std::vector<DrawnBlock> &blocks) {
	std::vector<ClumpPlan> plans;
	const std::vector<RankedPlant> plants = rank_plants(style, blocks);
	for (int level = 0; level < int(style.levels.size()); level++) {
		for (ClumpPlan &plan : plan_level(style, blocks, plants, level)) {
			plans.push_back(std::move(plan));
		}
	}
	return plans;
}

} // namespace undergrowth

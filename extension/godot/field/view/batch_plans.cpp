#include "field/view/batch_plans.hpp"

#include "base/bounded_whole.hpp"
#include "base/convert.hpp"
#include "base/counting_sort.hpp"
#include "field/view/ranked_plants.hpp"
#include "mesh/form_plan.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

using namespace godot;

namespace undergrowth {

// Cost of a draw in vertices: drawing this many invisible vertices costs as much as one more draw.
static constexpr float VERTICES_OF_DRAW = 3000.0f;
static constexpr int MAX_SQUARE_FACTOR = 8;
// The same at levels by error without end, where the estimate counts too many: a saved draw costs 1,200 triangles.
static constexpr float VERTICES_OF_FAR_DRAW = 12000.0f;
// Where such a level counts as ended (m). Wider squares would have too many plants beside the view and in each split of
// the shadows.
static constexpr float MAX_FAR_END = 60.0f;

// A field of at most this width (m) has one square at a level that ends farther than at this share of the width.
static constexpr float WHOLE_SHARE = 0.7f;
static constexpr int WHOLE_FACTOR = 1 << 20;

// Size of the squares of a species: tiles per side, or squares along a tile's side; one of the two is 1.
struct Squares {
	int factor = 1; // WHOLE_FACTOR: one square with all plants.
	int cuts = 1;
};

// Starts with the level's squares and widens those of sparse species, with a few plants each. Twice the side quarters
// the number of draws, but squares at the level's end draw more vertices beyond it. Stops when that costs more.
static Squares squares_of(
		const FieldRenderSetup &setup, int level, const SpeciesStyle &style, float plants_in_tile, float width) {
	const FieldLevel &seen = style.levels[size_t(level)];
	if (!seen.is_used || seen.is_near) {
		return Squares();
	}
	Squares squares = { setup.is_of_tiles ? 1 : seen.tile_factor, seen.tile_cuts };
	const float end = seen.end > 0.0f ? seen.end : 2.0f * seen.begin;
	const bool is_far = style.is_by_error && seen.end <= 0.0f;
	const float draw_end = is_far ? std::max(end, std::min(width, MAX_FAR_END)) : end;
	const float vertices_of_draw = is_far ? VERTICES_OF_FAR_DRAW : VERTICES_OF_DRAW;
	const float meshes = float(style.meshes[size_t(level)].size());
	const float vertices = plants_in_tile / meshes * float(vertex_budget(style.segments_at(seen)));
	while (squares.cuts > 1 || (squares.factor < MAX_SQUARE_FACTOR && !setup.is_of_tiles)) {
		const float tiles = float(squares.factor) / float(squares.cuts); // Along a side.
		const float side = tiles * setup.tile_size;
		if (side * 2.0f > draw_end || 2.0f * vertices * tiles * tiles * side > vertices_of_draw * draw_end) {
			break;
		}
		squares.cuts > 1 ? squares.cuts /= 2 : squares.factor *= 2;
	}
	if (!setup.is_of_tiles && style.is_by_error && width * WHOLE_SHARE <= end) {
		return { WHOLE_FACTOR, 1 };
	}
	return squares;
}

// Returns the width of the box around all roots of generated plants (m).
static float width_of(const std::vector<DrawnChunk> &chunks, const RankedPlants &ranked) {
	constexpr float FAR = std::numeric_limits<float>::max();
	glm::vec2 low(FAR), high(-FAR);
	for (size_t i = 0; i < chunks.size(); i++) {
		for (int k = ranked.begins[i]; k < ranked.begins[i + 1] && !chunks[i].chunk->is_added; k++) {
			const glm::vec3 &root = ranked.plants[size_t(k)].root;
			low = glm::min(low, glm::vec2(root.x, root.z));
			high = glm::max(high, glm::vec2(root.x, root.z));
		}
	}
	return std::max({ high.x - low.x, high.y - low.y, 0.0f });
}

// By species. Only for generated plants: multimeshes of added plants are found by their tiles.
static std::vector<Squares> all_squares(
		const FieldRenderSetup &setup, int level, const std::vector<DrawnChunk> &chunks, float width) {
	std::vector<float> plants(setup.styles.size(), 0.0f), tiles(setup.styles.size(), 0.0f);
	for (const DrawnChunk &drawn : chunks) {
		plants[size_t(drawn.chunk->species)] += float(drawn.chunk->size());
		tiles[size_t(drawn.chunk->species)] += 1.0f;
	}
	std::vector<Squares> squares;
	for (size_t i = 0; i < setup.styles.size(); i++) {
		squares.push_back(squares_of(setup, level, setup.styles[i], plants[i] / std::max(tiles[i], 1.0f), width));
	}
	return squares;
}

// The square of a level that contains a root. Squares smaller than a tile are parts of the chunk's own tile.
static BatchKey place_of(const FieldRenderSetup &setup, int level, const DrawnChunk &drawn, const Squares &squares,
		const glm::vec3 &root) {
	const PlantChunk &chunk = *drawn.chunk;
	if (drawn.new_chunk >= 0) {
		return { false, level, 1, chunk.tile, drawn.new_chunk };
	}
	if (squares.factor == WHOLE_FACTOR) {
		return { false, level, WHOLE_FACTOR, TileKey() };
	}
	if (squares.cuts == 1) {
		return { chunk.is_added, level, squares.factor, wider_tile(chunk.tile, squares.factor) };
	}
	const auto part = [&](float place, int tile) {
		const float way = place / setup.tile_size - float(tile);
		return bounded_whole(way * float(squares.cuts), 0, squares.cuts - 1);
	};
	const int number = part(root.z, chunk.tile.row) * squares.cuts + part(root.x, chunk.tile.column);
	return { chunk.is_added, level, 1, chunk.tile, -1, number };
}

// The multimeshes of a level, and the index of the multimesh of each plant.
struct Division {
	std::map<std::tuple<BatchKey, int, int>, int> numbers; // By place, species, group.
	std::vector<int> counts;
	std::vector<int> of_plants;
};

static void divide_chunk(const FieldRenderSetup &setup, const DrawnChunk &drawn, const Squares &squares, int level,
		const DrawnPlant *begin, const DrawnPlant *end, Division &division) {
	const int species = drawn.chunk->species;
	// One square contains all variants.
	const int groups = level == SQUARES ? 1 : int(setup.styles[size_t(species)].meshes[size_t(level)].size());
	// Few, so that the map is searched once for each.
	std::vector<int> found(size_t(squares.cuts * squares.cuts * groups), -1);
	for (const DrawnPlant *plant = begin; plant < end; plant++) {
		const BatchKey place = place_of(setup, level, drawn, squares, plant->root);
		const int group = int(plant->variant) % groups;
		int &number = found[size_t(std::max(place.part, 0) * groups + group)];
		if (number < 0) {
			const int next = int(division.numbers.size());
			number = division.numbers.try_emplace({ place, species, group }, next).first->second;
			division.counts.resize(division.numbers.size(), 0);
		}
		division.counts[size_t(number)]++;
		division.of_plants.push_back(number);
	}
}

// True if a species has plans: squares of single plants at SQUARES, multimeshes at the levels.
static bool is_planned(const SpeciesStyle &style, int level) {
	if (level == SQUARES) {
		return !style.errors.empty() && !style.model();
	}
	return style.levels[size_t(level)].is_used && !style.levels[size_t(level)].is_near;
}

static Division divide(
		const FieldRenderSetup &setup, const std::vector<DrawnChunk> &chunks, const RankedPlants &ranked, int level) {
	const bool is_of_squares = level == SQUARES;
	const std::vector<Squares> squares =
			is_of_squares ? std::vector<Squares>(setup.styles.size()) : all_squares(setup, level, chunks, ranked.width);
	const Squares of_added = is_of_squares
			? Squares()
			: Squares{ setup.levels[size_t(level)].tile_factor, setup.levels[size_t(level)].tile_cuts };
	Division division;
	division.of_plants.reserve(ranked.plants.size());
	for (size_t i = 0; i < chunks.size(); i++) {
		const PlantChunk &chunk = *chunks[i].chunk;
		if (!is_planned(setup.styles[size_t(chunk.species)], level)) {
			division.of_plants.insert(division.of_plants.end(), size_t(ranked.begins[i + 1] - ranked.begins[i]), -1);
			continue;
		}
		const Squares own = chunk.is_added ? of_added : squares[size_t(chunk.species)];
		const DrawnPlant *plants = ranked.plants.data();
		divide_chunk(setup, chunks[i], own, level, plants + ranked.begins[i], plants + ranked.begins[i + 1], division);
	}
	return division;
}

// Writes the plants of a plan by cells. Each cell's plants stay in the order of rank.
static void fill_square(const FieldRenderSetup &setup, const RankedPlants &ranked, const int *order, BatchPlan &plan) {
	constexpr float FAR = std::numeric_limits<float>::max();
	auto square = std::make_shared<NearSquare>();
	glm::vec3 lowest(FAR), highest(-FAR);
	for (int i = 0; i < plan.count; i++) {
		const glm::vec3 &root = ranked.plants[size_t(order[i])].root;
		lowest = glm::min(lowest, root);
		highest = glm::max(highest, root);
		square->reach = std::max(square->reach, ranked.reaches[size_t(order[i])]);
	}
	const glm::vec2 low(lowest.x, lowest.z), high(highest.x, highest.z);
	const auto cells = [](float metres) { return int(metres / NearSquare::CELL_SIZE) + 1; };
	square->species = plan.species;
	square->stride = setup.instance_floats();
	square->low = low;
	square->lowest = lowest.y;
	square->highest = highest.y;
	square->columns = cells(high.x - low.x);
	square->rows = cells(high.y - low.y);
	const auto cell_of = [&](int number) {
		const glm::vec3 &root = ranked.plants[size_t(number)].root;
		const int column = std::min(cells(root.x - low.x) - 1, square->columns - 1);
		return std::min(cells(root.z - low.y) - 1, square->rows - 1) * square->columns + column;
	};
	const std::vector<int> sorted =
			counting_sort(std::vector<int>(order, order + plan.count), square->columns * square->rows, cell_of);
	square->begins.assign(size_t(square->columns * square->rows) + 1, 0);
	square->plants.reserve(size_t(plan.count));
	for (const int number : sorted) {
		square->plants.push_back(ranked.plants[size_t(number)]);
		square->begins[size_t(cell_of(number)) + 1]++;
	}
	std::partial_sum(square->begins.begin(), square->begins.end(), square->begins.begin());
	square->drawn.assign(size_t(plan.count), 0);
	plan.near = std::move(square);
}

// Writes the plants `order` .. `order + plan.count` by rank. Plants that distance removes first are at the end.
static void fill_plan(const FieldRenderSetup &setup, const RankedPlants &ranked, const int *order, BatchPlan &plan) {
	constexpr float FAR = std::numeric_limits<float>::max();
	const float mesh_height = setup.styles[size_t(plan.species)].variants[size_t(plan.group)].height;
	glm::vec3 low(FAR), high(-FAR), lowest(FAR), highest(-FAR);
	plan.stride = setup.instance_floats();
	plan.buffer.resize(int64_t(plan.count) * plan.stride);
	float *to = plan.buffer.ptrw();
	for (int i = 0; i < plan.count; i++) {
		const DrawnPlant &plant = ranked.plants[size_t(order[i])];
		const glm::vec3 &root = plant.root;
		const float reach = ranked.reaches[size_t(order[i])];
		to = plant.write(plan.stride, mesh_height, to);
		low = glm::min(low, root);
		high = glm::max(high, root);
		lowest = glm::min(lowest, root - reach);
		highest = glm::max(highest, root + reach);
		plan.rank_counts[size_t(std::ceil(plant.rank() * RANK_STEPS))]++;
	}
	std::partial_sum(plan.rank_counts.begin(), plan.rank_counts.end(), plan.rank_counts.begin());
	plan.roots = AABB(to_godot(low), to_godot(high - low));
	plan.box = AABB(to_godot(lowest), to_godot(highest - lowest));
}

static void plan_level(const FieldRenderSetup &setup, const std::vector<DrawnChunk> &chunks, const RankedPlants &ranked,
		int level, std::vector<BatchPlan> &plans) {
	const Division division = divide(setup, chunks, ranked, level);
	const int count = int(division.counts.size());
	std::vector<int> planned;
	std::copy_if(ranked.by_rank.begin(), ranked.by_rank.end(), std::back_inserter(planned),
			[&](int plant) { return division.of_plants[size_t(plant)] >= 0; });
	const std::vector<int> order =
			counting_sort(planned, count, [&](int plant) { return division.of_plants[size_t(plant)]; });
	std::vector<int> begins(division.counts.size(), 0);
	for (int i = 1; i < count; i++) {
		begins[size_t(i)] = begins[size_t(i) - 1] + division.counts[size_t(i) - 1];
	}
	if (plans.capacity() < plans.size() + size_t(count)) {
		plans.reserve(2 * (plans.size() + size_t(count))); // Farther levels have fewer plans.
	}
	for (const auto &[key, number] : division.numbers) {
		plans.emplace_back();
		BatchPlan &plan = plans.back();
		std::tie(plan.place, plan.species, plan.group) = key;
		plan.count = division.counts[size_t(number)];
		(level == SQUARES ? fill_square : fill_plan)(setup, ranked, order.data() + begins[size_t(number)], plan);
	}
}

std::vector<BatchPlan> plan_level(const FieldRenderSetup &setup, const std::vector<DrawnChunk> &chunks, int level) {
	std::vector<BatchPlan> plans;
	RankedPlants ranked = rank_plants(setup, chunks);
	ranked.width = width_of(chunks, ranked);
	plan_level(setup, chunks, ranked, level, plans);
	return plans;
}

std::vector<BatchPlan> plan_batches(const FieldRenderSetup &setup, const std::vector<DrawnChunk> &chunks) {
	std::vector<BatchPlan> plans;
	RankedPlants ranked = rank_plants(setup, chunks);
	ranked.width = width_of(chunks, ranked);
	for (int level = SQUARES; level < int(setup.levels.size()); level++) {
		plan_level(setup, chunks, ranked, level, plans);
	}
	return plans;
}

} // namespace undergrowth

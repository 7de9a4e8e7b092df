// Plans the multimeshes of a field: their plants, positions, and locations of poses.

#include "field/field_view.hpp"

#include "base/bounded_whole.hpp"
#include "base/counting_sort.hpp"
#include "convert.hpp"
#include "field/ranked_plants.hpp"
#include "mesh/form_plan.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

using namespace godot;

namespace undergrowth {

static constexpr int TRANSFORM_FLOATS = 12; // 3x4, by rows.
static constexpr int COLOR_FLOATS = 4;
static constexpr int CUSTOM_FLOATS = 4;

// Cost of a draw in vertices: drawing this many invisible vertices costs as much as one more draw.
static constexpr float VERTICES_OF_DRAW = 3000.0f;
static constexpr int MAX_SQUARE_FACTOR = 8;

// Size of the squares of a species: tiles per side, or squares along a tile's side; one of the two is 1.
struct Squares {
	int factor = 1;
	int cuts = 1;
};

// Starts with the level's squares and widens those of sparse species, with a few plants each. Twice the side quarters
// the number of draws, but squares at the level's end draw more vertices beyond it. Stops when that costs more.
static Squares squares_of(const FieldRenderSetup &setup, int level, const SpeciesStyle &style, float plants_in_tile) {
	const FieldLevel &seen = setup.levels[size_t(level)];
	Squares squares = { setup.is_of_tiles ? 1 : seen.tile_factor, seen.tile_cuts };
	const float end = seen.end > 0.0f ? seen.end : 2.0f * seen.begin;
	const float meshes = float(style.meshes[size_t(level)].size());
	const float vertices = plants_in_tile / meshes * float(vertex_budget(style.segments_at(seen)));
	while (squares.cuts > 1 || (squares.factor < MAX_SQUARE_FACTOR && !setup.is_of_tiles)) {
		const float tiles = float(squares.factor) / float(squares.cuts); // Along a side.
		const float side = tiles * setup.tile_size;
		if (side * 2.0f > end || 2.0f * vertices * tiles * tiles * side > VERTICES_OF_DRAW * end) {
			break;
		}
		squares.cuts > 1 ? squares.cuts /= 2 : squares.factor *= 2;
	}
	return squares;
}

// By species. Only for generated plants: multimeshes of added plants are found by their tiles.
static std::vector<Squares> all_squares(
		const FieldRenderSetup &setup, int level, const std::vector<DrawnChunk> &chunks) {
	std::vector<float> plants(setup.styles.size(), 0.0f), tiles(setup.styles.size(), 0.0f);
	for (const DrawnChunk &drawn : chunks) {
		plants[size_t(drawn.chunk->species)] += float(drawn.chunk->size());
		tiles[size_t(drawn.chunk->species)] += 1.0f;
	}
	std::vector<Squares> squares;
	for (size_t i = 0; i < setup.styles.size(); i++) {
		squares.push_back(squares_of(setup, level, setup.styles[i], plants[i] / std::max(tiles[i], 1.0f)));
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
	const int groups = int(setup.styles[size_t(species)].meshes[size_t(level)].size());
	// Few, so that the map is searched once for each.
	std::vector<int> found(size_t(squares.cuts * squares.cuts * groups), -1);
	for (const DrawnPlant *plant = begin; plant < end; plant++) {
		const BatchKey place = place_of(setup, level, drawn, squares, plant->root);
		const int group = plant->variant % groups;
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

static Division divide(
		const FieldRenderSetup &setup, const std::vector<DrawnChunk> &chunks, const RankedPlants &ranked, int level) {
	const FieldLevel &seen = setup.levels[size_t(level)];
	const std::vector<Squares> squares = all_squares(setup, level, chunks);
	Division division;
	division.of_plants.reserve(ranked.plants.size());
	for (size_t i = 0; i < chunks.size(); i++) {
		const PlantChunk &chunk = *chunks[i].chunk;
		const Squares own =
				chunk.is_added ? Squares{ seen.tile_factor, seen.tile_cuts } : squares[size_t(chunk.species)];
		const DrawnPlant *plants = ranked.plants.data();
		divide_chunk(setup, chunks[i], own, level, plants + ranked.begins[i], plants + ranked.begins[i + 1], division);
	}
	return division;
}

// Writes a plant to a plan's buffer and returns the position after it.
static float *write_plant(const FieldRenderSetup &setup, const DrawnPlant &plant, float mesh_height, float *to) {
	const float transform[TRANSFORM_FLOATS] = { plant.cosine, 0.0f, plant.sine, plant.root.x, //
		0.0f, plant.scale, 0.0f, plant.root.y, //
		-plant.sine, 0.0f, plant.cosine, plant.root.z };
	to = std::copy(std::begin(transform), std::end(transform), to);
	if (setup.needs_colors) {
		to = std::fill_n(to, COLOR_FLOATS, 1.0f); // White.
	}
	for (const float number : { plant.texel, plant.layer, plant.rank, plant.height / mesh_height }) {
		*to++ = number;
	}
	return to;
}

// Writes the plants `order` .. `order + plan.count` by rank. Plants that distance removes first are at the end.
static void fill_plan(const FieldRenderSetup &setup, const RankedPlants &ranked, const int *order, BatchPlan &plan) {
	constexpr float FAR = std::numeric_limits<float>::max();
	const float mesh_height = setup.styles[size_t(plan.species)].variants[size_t(plan.group)].height;
	glm::vec3 low(FAR), high(-FAR), lowest(FAR), highest(-FAR);
	plan.stride = TRANSFORM_FLOATS + CUSTOM_FLOATS + (setup.needs_colors ? COLOR_FLOATS : 0);
	plan.buffer.resize(int64_t(plan.count) * plan.stride);
	float *to = plan.buffer.ptrw();
	for (int i = 0; i < plan.count; i++) {
		const DrawnPlant &plant = ranked.plants[size_t(order[i])];
		const glm::vec3 &root = plant.root;
		to = write_plant(setup, plant, mesh_height, to);
		low = glm::min(low, root);
		high = glm::max(high, root);
		lowest = glm::min(lowest, root - plant.reach);
		highest = glm::max(highest, root + plant.reach);
		plan.kept[size_t(plant.step)]++;
	}
	std::partial_sum(plan.kept.begin(), plan.kept.end(), plan.kept.begin());
	plan.roots = AABB(to_godot(low), to_godot(high - low));
	plan.box = AABB(to_godot(lowest), to_godot(highest - lowest));
}

static void plan_level(const FieldRenderSetup &setup, const std::vector<DrawnChunk> &chunks, const RankedPlants &ranked,
		int level, std::vector<BatchPlan> &plans) {
	const Division division = divide(setup, chunks, ranked, level);
	const int count = int(division.counts.size());
	const std::vector<int> order =
			counting_sort(ranked.by_rank, count, [&](int plant) { return division.of_plants[size_t(plant)]; });
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
		fill_plan(setup, ranked, order.data() + begins[size_t(number)], plan);
	}
}

std::vector<BatchPlan> plan_level(const FieldRenderSetup &setup, const std::vector<DrawnChunk> &chunks, int level) {
	std::vector<BatchPlan> plans;
	plan_level(setup, chunks, rank_plants(setup, chunks), level, plans);
	return plans;
}

std::vector<BatchPlan> plan_batches(const FieldRenderSetup &setup, const std::vector<DrawnChunk> &chunks) {
	std::vector<BatchPlan> plans;
	const RankedPlants ranked = rank_plants(setup, chunks);
	for (int level = 0; level < int(setup.levels.size()); level++) {
		plan_level(setup, chunks, ranked, level, plans);
	}
	return plans;
}

} // namespace undergrowth

#include "placement/chunks.hpp"

#include "base/bounded_whole.hpp"
#include "base/counting_sort.hpp"
#include "placement/curve_key.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace undergrowth {

namespace {

constexpr float USUAL_SIZE = 16.0f; ///< m.
constexpr int FARTHEST_TILE = 1000000000;
constexpr int KINDS = 65536; ///< Species times variants.

int tile_coordinate(float place, float size) {
	const double tile = std::floor(static_cast<double>(place) / static_cast<double>(size));
	return bounded_whole(tile, -FARTHEST_TILE, FARTHEST_TILE);
}

/// Lowest coordinate of a tile, to the bit: the product can be rounded to a neighbouring number.
float tile_side(int tile, float size) {
	constexpr float FAR = std::numeric_limits<float>::max();
	auto side = static_cast<float>(static_cast<double>(tile) * static_cast<double>(size));
	if (std::abs(tile) >= FARTHEST_TILE) {
		return side; // All plants are in one tile.
	}
	while (tile_coordinate(side, size) < tile) {
		side = std::nextafter(side, FAR);
	}
	while (tile_coordinate(std::nextafter(side, -FAR), size) >= tile) {
		side = std::nextafter(side, -FAR);
	}
	return side;
}

int kind_of(const FieldPlants &plants, std::size_t i) {
	return plants.species[i] * 256 + plants.variant[i];
}

/// Finds tiles along the curve, and for each plant the index of its tile.
std::vector<TileKey> find_tiles(const FieldPlants &plants, float size, std::vector<int> &of_plant) {
	const std::size_t count = plants.x.size();
	std::vector<uint64_t> keys(count);
	std::vector<std::pair<uint64_t, TileKey>> found;
	for (std::size_t i = 0; i < count; i++) {
		const TileKey tile = tile_at(plants.x[i], plants.z[i], size);
		// Plants come in rows: most are in the same tile as the one before.
		if (i > 0 && tile == found.back().second) {
			keys[i] = keys[i - 1];
			continue;
		}
		keys[i] = curve_key(tile.column, tile.row);
		found.emplace_back(keys[i], tile);
	}
	const auto is_before = [](const auto &a, const auto &b) { return a.first < b.first; };
	const auto is_same = [](const auto &a, const auto &b) { return a.first == b.first; };
	std::sort(found.begin(), found.end(), is_before);
	found.erase(std::unique(found.begin(), found.end(), is_same), found.end());
	of_plant.resize(count);
	for (std::size_t i = 0; i < count; i++) {
		if (i > 0 && keys[i] == keys[i - 1]) {
			of_plant[i] = of_plant[i - 1];
			continue;
		}
		const std::pair<uint64_t, TileKey> wanted = { keys[i], {} };
		of_plant[i] = static_cast<int>(std::lower_bound(found.begin(), found.end(), wanted, is_before) - found.begin());
	}
	std::vector<TileKey> tiles;
	for (const auto &entry : found) {
		tiles.push_back(entry.second);
	}
	return tiles;
}

/// Chunk of the plants order[begin] to order[end - 1], all of one tile and species.
PlantChunk make_chunk(const FieldPlants &plants, const std::vector<int> &order, std::size_t begin, std::size_t end,
		const TileKey &tile) {
	PlantChunk chunk;
	chunk.tile = tile;
	const auto first = order.begin() + static_cast<std::ptrdiff_t>(begin);
	chunk.plants = plants.reordered({ first, order.begin() + static_cast<std::ptrdiff_t>(end) });
	chunk.species = chunk.plants.species.front();
	chunk.low = chunk.high = chunk.root(0);
	for (int slot = 1; slot < chunk.size(); slot++) {
		chunk.low = glm::min(chunk.low, chunk.root(slot));
		chunk.high = glm::max(chunk.high, chunk.root(slot));
	}
	return chunk;
}

} // namespace

TileKey tile_at(float x, float z, float size) {
	return { tile_coordinate(x, size), tile_coordinate(z, size) };
}

AreaBox tile_box(const TileKey &tile, float size) {
	return { { tile_side(tile.column, size), tile_side(tile.row, size) },
		{ tile_side(tile.column + 1, size), tile_side(tile.row + 1, size) } };
}

TileKey wider_tile(const TileKey &tile, int factor) {
	const auto down = [factor](int count) { return count / factor - static_cast<int>(count % factor < 0); };
	return { down(tile.column), down(tile.row) };
}

void PlantChunk::add(const PlacedPlant &plant) {
	plants.add(plant);
	low = size() == 1 ? plant.root : glm::min(low, plant.root);
	high = size() == 1 ? plant.root : glm::max(high, plant.root);
}

std::vector<PlantChunk> cut_into_chunks(const FieldPlants &plants, float tile_size) {
	const float size = std::isfinite(tile_size) && tile_size > 0.0f ? tile_size : USUAL_SIZE;
	std::vector<int> of_plant;
	const std::vector<TileKey> tiles = find_tiles(plants, size, of_plant);
	std::vector<int> order(plants.x.size());
	for (std::size_t i = 0; i < order.size(); i++) {
		order[i] = static_cast<int>(i);
	}
	const auto kind = [&](int i) { return kind_of(plants, static_cast<std::size_t>(i)); };
	const auto tile = [&](int i) { return of_plant[static_cast<std::size_t>(i)]; };
	order = counting_sort(order, KINDS, kind);
	order = counting_sort(order, static_cast<int>(tiles.size()), tile);
	std::vector<PlantChunk> chunks;
	for (std::size_t begin = 0; begin < order.size();) {
		std::size_t end = begin;
		const int species = plants.species[static_cast<std::size_t>(order[begin])];
		while (end < order.size() && end - begin < PlantChunk::MAX_PLANTS && tile(order[end]) == tile(order[begin]) &&
				plants.species[static_cast<std::size_t>(order[end])] == species) {
			end++;
		}
		chunks.push_back(make_chunk(plants, order, begin, end, tiles[static_cast<std::size_t>(tile(order[begin]))]));
		begin = end;
	}
	return chunks;
}

} // namespace undergrowth

#include "placement/chunks.hpp"
#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

using namespace undergrowth;

namespace {

/// Plants on hills, shuffled by `order_seed`; 0 leaves them in the order of placement.
FieldPlants hilly_field(float side, float density, uint64_t order_seed = 0) {
	PlacementRequest request = square_field(side, density, 5);
	request.clumping = 0.5f;
	FieldPlants plants = placed(request);
	std::vector<int> order;
	for (int i = 0; i < plants.size(); i++) {
		const auto at = static_cast<std::size_t>(i);
		plants.y[at] = 3.0f * std::sin(plants.x[at] * 0.2f) + 0.1f * plants.z[at];
		order.push_back(i);
	}
	const uint64_t stride = order_seed * 2654435761u;
	std::sort(order.begin(), order.end(), [&](int a, int b) {
		return static_cast<uint32_t>(static_cast<uint64_t>(a) * stride) <
				static_cast<uint32_t>(static_cast<uint64_t>(b) * stride);
	});
	return order_seed == 0 ? plants : plants.reordered(order);
}

using Key = std::tuple<int, int, int>;

/// The tile and species of a plant, by definition.
Key key_of(const FieldPlants &plants, std::size_t i, double size) {
	return { static_cast<int>(std::floor(plants.z[i] / size)), static_cast<int>(std::floor(plants.x[i] / size)),
		plants.species[i] };
}

} // namespace

TEST_CASE("plants beyond all tiles, and positions with invalid numbers, have a tile") {
	const TileKey farthest = tile_at(1e31f, -3e38f, 0.5f);
	CHECK(farthest.column == 1000000000);
	CHECK(farthest.row == -1000000000);
	const float infinite = std::numeric_limits<float>::infinity();
	CHECK(tile_at(infinite, -infinite, 16.0f) == farthest);
	const float nothing = std::numeric_limits<float>::quiet_NaN();
	CHECK(tile_at(nothing, nothing, 16.0f) == TileKey{ -1000000000, -1000000000 });
	FieldPlants plants;
	for (const float x : { 0.0f, 1e31f, 1.1e31f, -1e38f }) {
		PlacedPlant plant;
		plant.root = { x, 0.0f, x };
		REQUIRE(plants.add(plant));
	}
	CHECK(cut_into_chunks(plants, 16.0f).size() == 3);
}

TEST_CASE("blocks contain all plants exactly once, each of one tile and species") {
	const FieldPlants plants = hilly_field(100.0f, 4.0f, 3);
	const std::vector<PlantChunk> chunks = cut_into_chunks(plants, 10.0f);
	std::multiset<float> was(plants.x.begin(), plants.x.end());
	std::multiset<float> is;
	std::set<Key> seen;
	for (const PlantChunk &chunk : chunks) {
		const Key key = { chunk.tile.row, chunk.tile.column, chunk.species };
		CHECK(seen.insert(key).second);
		CHECK(chunk.size() > 0);
		CHECK(chunk.live_count() == chunk.size());
		for (int slot = 0; slot < chunk.size(); slot++) {
			const auto at = static_cast<std::size_t>(slot);
			CHECK(key_of(chunk.plants, at, 10.0) == key);
			CHECK((slot == 0 || chunk.plants.variant[at] >= chunk.plants.variant[at - 1]));
			CHECK(glm::min(chunk.root(slot), chunk.low) == chunk.low);
			CHECK(glm::max(chunk.root(slot), chunk.high) == chunk.high);
			is.insert(chunk.plants.x[at]);
		}
		CHECK(chunk.low.x == *std::min_element(chunk.plants.x.begin(), chunk.plants.x.end()));
		CHECK(chunk.high.z == *std::max_element(chunk.plants.z.begin(), chunk.plants.z.end()));
	}
	CHECK(was == is);
}

TEST_CASE("equal plants preserve their order, for any order of all other plants") {
	const FieldPlants plants = hilly_field(60.0f, 5.0f, 5);
	std::map<std::tuple<int, int, int, int>, std::vector<float>> was;
	std::map<std::tuple<int, int, int, int>, std::vector<float>> is;
	for (std::size_t i = 0; i < plants.x.size(); i++) {
		was[std::tuple_cat(key_of(plants, i, 16.0), std::make_tuple(int(plants.variant[i])))].push_back(plants.x[i]);
	}
	for (const PlantChunk &chunk : cut_into_chunks(plants, 16.0f)) {
		for (std::size_t i = 0; i < chunk.plants.x.size(); i++) {
			is[std::tuple_cat(key_of(chunk.plants, i, 16.0), std::make_tuple(int(chunk.plants.variant[i])))].push_back(
					chunk.plants.x[i]);
		}
	}
	CHECK(was == is);
}

TEST_CASE("each tile is beside the one before") {
	const FieldPlants plants = hilly_field(127.0f, 1.0f);
	std::vector<TileKey> tiles;
	for (const PlantChunk &chunk : cut_into_chunks(plants, 8.0f)) {
		if (tiles.empty() || !(tiles.back() == chunk.tile)) {
			tiles.push_back(chunk.tile);
		}
	}
	double way = 0.0;
	for (std::size_t i = 1; i < tiles.size(); i++) {
		way += std::hypot(tiles[i - 1].column - tiles[i].column, tiles[i - 1].row - tiles[i].row);
	}
	// A square of 16 by 16 tiles is four pieces of Hilbert's curve without a jump.
	REQUIRE(tiles.size() == 256);
	CHECK(way == doctest::Approx(255.0));
}

TEST_CASE("a tile with more plants of a species than a block can contain has several blocks") {
	const FieldPlants plants = hilly_field(60.0f, 5.0f);
	int total = 0;
	std::map<int, std::vector<int>> sizes;
	for (const PlantChunk &chunk : cut_into_chunks(plants, 1000.0f)) {
		total += chunk.size();
		sizes[chunk.species].push_back(chunk.size());
	}
	CHECK(total == plants.size());
	for (const auto &[species, of_species] : sizes) {
		for (std::size_t i = 0; i + 1 < of_species.size(); i++) {
			CHECK((of_species[i] == PlantChunk::MAX_PLANTS || of_species[i + 1] > 0));
		}
		CHECK(*std::max_element(of_species.begin(), of_species.end()) <= PlantChunk::MAX_PLANTS);
	}
}

TEST_CASE("no plants, one plant and plants far apart have their tiles") {
	FieldPlants plants;
	CHECK(cut_into_chunks(plants, 16.0f).empty());
	PlacedPlant plant;
	plant.root = { -0.5f, 3.0f, 20.0f };
	plants.add(plant);
	std::vector<PlantChunk> chunks = cut_into_chunks(plants, 16.0f);
	REQUIRE(chunks.size() == 1);
	CHECK(chunks[0].tile.column == -1);
	CHECK(chunks[0].tile.row == 1);
	for (const float place : { -3.0e38f, 3.0e38f, 1.0e7f }) {
		plant.root = { place, 0.0f, -place };
		plants.add(plant);
	}
	CHECK(cut_into_chunks(plants, 16.0f).size() == 4);
	CHECK(cut_into_chunks(plants, 0.0f).size() == 4);
	CHECK(cut_into_chunks(plants, std::numeric_limits<float>::quiet_NaN()).size() == 4);
}

TEST_CASE("a wider tile holds the tiles within it on both sides of the origin") {
	for (int column = -9; column <= 9; column++) {
		for (const int factor : { 1, 2, 4 }) {
			const TileKey wide = wider_tile({ column, -column }, factor);
			const auto size = static_cast<float>(factor);
			CHECK(wide == tile_at(static_cast<float>(column) + 0.5f, static_cast<float>(-column) + 0.5f, size));
		}
	}
}

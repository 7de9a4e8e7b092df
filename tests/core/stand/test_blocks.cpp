#include "field/chunks.hpp"
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

const std::vector<float> REACHES = { 1.0f, 0.5f, 2.0f, 0.0f, 0.25f };

/// Plants on hills, mixed by `order_seed`; 0 leaves them as they were placed.
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

FieldChunks sorted(FieldPlants &plants, float size = 16.0f) {
	return sort_into_chunks(plants, size, REACHES.data(), static_cast<int>(REACHES.size()));
}

using Key = std::tuple<int, int, int, int>;

/// The chunk, species and variant of a plant, by their definition.
Key key_of(const FieldPlants &plants, std::size_t i, double size) {
	return { static_cast<int>(std::floor(plants.z[i] / size)), static_cast<int>(std::floor(plants.x[i] / size)),
		plants.species[i], plants.variant[i] };
}

} // namespace

TEST_CASE("chunks and their ranges cover all plants exactly once") {
	FieldPlants plants = hilly_field(100.0f, 4.0f, 3);
	const FieldChunks field = sorted(plants, 10.0f);
	CHECK(field.chunks.size() == 100);
	int next = 0;
	int next_range = 0;
	std::set<std::pair<int, int>> seen;
	for (const FieldChunk &chunk : field.chunks) {
		CHECK(seen.insert({ chunk.column, chunk.row }).second);
		CHECK(chunk.begin == next);
		CHECK(chunk.end > chunk.begin);
		CHECK(chunk.first_range == next_range);
		int before = -1;
		for (int r = chunk.first_range; r < chunk.last_range; r++) {
			const ChunkRange &range = field.ranges[static_cast<std::size_t>(r)];
			CHECK(range.begin == next);
			CHECK(range.end > range.begin);
			CHECK(range.species * 256 + range.variant > before);
			before = range.species * 256 + range.variant;
			for (int i = range.begin; i < range.end; i++) {
				const Key key = { chunk.row, chunk.column, range.species, range.variant };
				CHECK(key_of(plants, static_cast<std::size_t>(i), 10.0) == key);
			}
			next = range.end;
		}
		CHECK(chunk.end == next);
		next_range = chunk.last_range;
	}
	CHECK(next == plants.size());
	CHECK(next_range == static_cast<int>(field.ranges.size()));
}

TEST_CASE("sorting keeps every plant, and equal ones in their order") {
	const FieldPlants before = hilly_field(60.0f, 5.0f, 5);
	FieldPlants plants = before;
	sorted(plants);
	REQUIRE(plants.size() == before.size());
	std::map<Key, std::vector<float>> was;
	std::map<Key, std::vector<float>> is;
	for (std::size_t i = 0; i < before.x.size(); i++) {
		was[key_of(before, i, 16.0)].push_back(before.x[i] + 1000.0f * before.scale[i] + before.turn[i]);
		is[key_of(plants, i, 16.0)].push_back(plants.x[i] + 1000.0f * plants.scale[i] + plants.turn[i]);
	}
	CHECK(was == is);
	FieldPlants again = plants;
	sorted(again);
	CHECK(hash_of(again) == hash_of(plants));
}

TEST_CASE("a chunk's box holds every place that its plants can reach, and no more than that in breadth") {
	FieldPlants plants = hilly_field(80.0f, 3.0f);
	const FieldChunks field = sorted(plants);
	for (const FieldChunk &chunk : field.chunks) {
		for (int i = chunk.begin; i < chunk.end; i++) {
			const PlacedPlant plant = plants.plant(i);
			const float length = REACHES[static_cast<std::size_t>(plant.species)] * plant.scale * plant.height;
			for (int k = 0; k < 26; k++) {
				const float turn = static_cast<float>(k) * 0.25f;
				const glm::vec3 aside = { std::cos(turn), 0.3f * std::sin(3.0f * turn), std::sin(turn) };
				const glm::vec3 tip = plant.root + aside / std::max(1.0f, std::sqrt(1.09f)) * length;
				CHECK(glm::min(tip, chunk.low) == chunk.low);
				CHECK(glm::max(tip, chunk.high) == chunk.high);
			}
			const glm::vec3 top = plant.root + glm::vec3(0.0f, length, 0.0f);
			CHECK(top.y <= chunk.high.y);
		}
		// The longest plant: reach 2 m, scale 1.25, height 1.3.
		CHECK(chunk.low.x >= static_cast<float>(chunk.column) * 16.0f - 3.26f);
		CHECK(chunk.high.z <= static_cast<float>(chunk.row + 1) * 16.0f + 3.26f);
	}
}

TEST_CASE("reaches that are missing, negative or not numbers count as none") {
	FieldPlants plants = hilly_field(10.0f, 3.0f);
	const float reaches[] = { -1.0f, std::numeric_limits<float>::quiet_NaN() };
	const FieldChunks field = sort_into_chunks(plants, 100.0f, reaches, 2);
	for (const FieldChunk &chunk : field.chunks) {
		const auto begin = plants.x.begin();
		CHECK(chunk.low.x == *std::min_element(begin + chunk.begin, begin + chunk.end));
		CHECK(chunk.high.x == *std::max_element(begin + chunk.begin, begin + chunk.end));
	}
}

TEST_CASE("each chunk is beside the one before") {
	FieldPlants plants = hilly_field(127.0f, 1.0f);
	const FieldChunks field = sorted(plants, 8.0f);
	double way = 0.0;
	for (std::size_t i = 1; i < field.chunks.size(); i++) {
		const FieldChunk &a = field.chunks[i - 1];
		const FieldChunk &b = field.chunks[i];
		way += std::hypot(a.column - b.column, a.row - b.row) / static_cast<double>(field.chunks.size() - 1);
	}
	// A square of 16 by 16 chunks is four pieces of Hilbert's curve without a jump.
	CHECK(field.chunks.size() == 256);
	CHECK(way == doctest::Approx(1.0));
}

TEST_CASE("no plants, one plant and plants far apart have their chunks") {
	FieldPlants plants;
	CHECK(sorted(plants).chunks.empty());
	CHECK(plan_pages(sorted(plants)).pages.empty());
	CHECK(find_in_sphere(plants, sorted(plants), { 0, 0, 0 }, 10.0f).empty());

	PlacedPlant plant;
	plant.root = { -0.5f, 3.0f, 20.0f };
	plants.add(plant);
	FieldChunks field = sorted(plants);
	REQUIRE(field.chunks.size() == 1);
	CHECK(field.chunks[0].column == -1);
	CHECK(field.chunks[0].row == 1);
	CHECK(field.ranges.size() == 1);

	for (const float place : { -3.0e38f, 3.0e38f, 1.0e7f }) {
		plant.root = { place, 0.0f, -place };
		plants.add(plant);
	}
	field = sorted(plants);
	CHECK(field.chunks.size() == 4);
	CHECK(field.chunks.back().end == 4);
	CHECK(sorted(plants, 0.0f).size == 16.0f);
	CHECK(sorted(plants, std::numeric_limits<float>::quiet_NaN()).size == 16.0f);
}

TEST_CASE("what a sphere holds is found without looking elsewhere") {
	FieldPlants plants = hilly_field(100.0f, 3.0f, 7);
	const FieldChunks field = sorted(plants);
	const glm::vec3 centres[] = { { 0, 0, 0 }, { 31, 2, -16 }, { 49, 0, 49 }, { 300, 0, 0 } };
	for (const glm::vec3 &centre : centres) {
		for (const float radius : { 0.0f, 1.5f, 20.0f, 1.0e4f, 1.0e30f }) {
			std::vector<int> expected;
			for (int i = 0; i < plants.size(); i++) {
				const glm::dvec3 way = glm::dvec3(plants.plant(i).root) - glm::dvec3(centre);
				if (way.x * way.x + way.y * way.y + way.z * way.z <= static_cast<double>(radius) * radius) {
					expected.push_back(i);
				}
			}
			CHECK(find_in_sphere(plants, field, centre, radius) == expected);
		}
	}
	CHECK(find_in_sphere(plants, field, plants.plant(17).root, 0.0f) == std::vector<int>{ 17 });
	CHECK(find_in_sphere(plants, field, { 0, 0, 0 }, -1.0f).empty());
	CHECK(find_in_sphere(plants, field, { 0, 0, 0 }, std::numeric_limits<float>::quiet_NaN()).empty());
}

#include "placement/chunks.hpp"
#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <map>
#include <vector>

using namespace undergrowth;

namespace {

constexpr float TILES[] = { 16.0f, 10.1f, 3.7f };

std::map<TileKey, std::vector<PlantChunk>> by_tile(const std::vector<PlantChunk> &chunks) {
	std::map<TileKey, std::vector<PlantChunk>> sorted;
	for (const PlantChunk &chunk : chunks) {
		sorted[chunk.tile].push_back(chunk);
	}
	return sorted;
}

/// A crooked area with a hole.
PlacementRequest crooked(float density) {
	PlacementRequest request = square_field(60.0f, density, 3);
	request.area = { { -30.0f, -25.0f }, { 31.3f, -18.0f }, { 20.0f, 27.0f }, { 2.0f, 4.0f }, { -28.0f, 26.0f } };
	request.exclusions = { rectangle({ 9.0f, 7.0f }, { -4.0f, -9.0f }) };
	request.clumping = 0.6f;
	return request;
}

} // namespace

TEST_CASE("a tile that is placed alone has the same bytes as in the whole area") {
	for (const float size : TILES) {
		PlacementRequest request = crooked(17.0f);
		request.edge_falloff = size == TILES[0] ? 0.0f : 0.8f;
		const auto whole = by_tile(cut_into_chunks(placed(request), size));
		REQUIRE(whole.size() > 8);
		int plants = 0;
		for (const auto &[tile, chunks] : whole) {
			PlacementRequest part = request;
			part.within = tile_box(tile, size);
			const std::vector<PlantChunk> alone = cut_into_chunks(placed(part), size);
			REQUIRE(alone.size() == chunks.size());
			for (std::size_t i = 0; i < alone.size(); i++) {
				REQUIRE(alone[i].tile == tile);
				REQUIRE(alone[i].species == chunks[i].species);
				REQUIRE(hash_of(alone[i].plants) == hash_of(chunks[i].plants));
				plants += alone[i].size();
			}
		}
		CHECK(plants == placed(request).size());
	}
}

TEST_CASE("a tile's box is the range of its plants, to the bit") {
	for (const float size : { 16.0f, 10.1f, 0.3f, 999.7f }) {
		for (int column = -2000; column < 2000; column += 7) {
			const AreaBox box = tile_box({ column, -column }, size);
			REQUIRE(tile_at(box.low.x, box.low.y, size) == TileKey{ column, -column });
			const float below = std::nextafter(box.low.x, -std::numeric_limits<float>::max());
			REQUIRE(tile_at(below, box.low.y, size).column == column - 1);
			REQUIRE(box.high.x == tile_box({ column + 1, 0 }, size).low.x);
		}
	}
}

TEST_CASE("a box outside of the area has no plants, and boxes can place an area of any size") {
	PlacementRequest request = crooked(17.0f);
	request.within = AreaBox{ { 100.0f, 0.0f }, { 116.0f, 16.0f } };
	CHECK(placed(request).size() == 0);
	request.within = AreaBox{ { 0.0f, 100.0f }, { 16.0f, 116.0f } };
	CHECK(placed(request).size() == 0);
	request = square_field(1.9e5f, 20.0f, 1);
	CHECK(find_placement_fault(request) == PlacementFault::too_many_plants);
	request.within = AreaBox{ { 8000.0f, -9000.0f }, { 8016.0f, -8984.0f } };
	CHECK(find_placement_fault(request) == PlacementFault::none);
	CHECK(placed(request).size() == doctest::Approx(20 * 256).epsilon(0.05));
}

TEST_CASE("only exclusions that reach into the box have an effect") {
	PlacementRequest request = square_field(40.0f, 5.0f, 2);
	request.within = AreaBox{ { -4.0f, -4.0f }, { 4.0f, 4.0f } };
	const uint64_t alone = hash_of(placed(request));
	for (int i = 0; i < 50; i++) {
		request.exclusions.push_back(rectangle({ 2.0f, 2.0f }, { 8.0f + static_cast<float>(i), 0.0f }));
	}
	CHECK(hash_of(placed(request)) == alone);
	request.exclusions.push_back(rectangle({ 2.0f, 2.0f }, { 4.5f, 0.0f }));
	CHECK(hash_of(placed(request)) != alone);
}

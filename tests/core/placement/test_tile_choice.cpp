#include "placement/tile_choice.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace undergrowth;

namespace {

constexpr float SIZE = 16.0f;
constexpr AreaBox EVERYWHERE = { { -1.0e5f, -1.0e5f }, { 1.0e5f, 1.0e5f } };

std::set<TileKey> after(std::set<TileKey> existing, const TileChoice &choice) {
	existing.insert(choice.to_load.begin(), choice.to_load.end());
	for (const TileKey &tile : choice.to_unload) {
		existing.erase(tile);
	}
	return existing;
}

} // namespace

TEST_CASE("all tiles around a camera are added, nearest first") {
	const std::vector<glm::vec2> places = { { 5.0f, -7.0f } };
	const TileChoice choice = choose_tiles({}, places, 60.0f, SIZE, EVERYWHERE);
	CHECK(choice.to_unload.empty());
	const std::set<TileKey> chosen(choice.to_load.begin(), choice.to_load.end());
	for (int column = -8; column <= 8; column++) {
		for (int row = -8; row <= 8; row++) {
			const bool is_near = distance_to_tile({ column, row }, SIZE, places) <= 60.0f;
			CHECK((chosen.count({ column, row }) > 0) == is_near);
		}
	}
	CHECK(choice.to_load.front() == tile_at(5.0f, -7.0f, SIZE));
	CHECK(std::is_sorted(choice.to_load.begin(), choice.to_load.end(), [&](const TileKey &a, const TileKey &b) {
		return distance_to_tile(a, SIZE, places) < distance_to_tile(b, SIZE, places);
	}));
}

TEST_CASE("on a walk no tile is added and removed at once, and distant ones are removed") {
	std::set<TileKey> existing;
	std::size_t max = 0;
	for (int metre = 0; metre < 1000; metre++) {
		const std::vector<glm::vec2> places = { { static_cast<float>(metre), 3.0f } };
		const std::set<TileKey> next = after(existing, choose_tiles(existing, places, 100.0f, SIZE, EVERYWHERE));
		const TileChoice again = choose_tiles(next, places, 100.0f, SIZE, EVERYWHERE);
		REQUIRE(again.to_load.empty());
		REQUIRE(again.to_unload.empty());
		const TileChoice back = choose_tiles(next, { places[0] - glm::vec2(8.0f, 0.0f) }, 100.0f, SIZE, EVERYWHERE);
		REQUIRE(back.to_load.size() < 8);
		existing = next;
		max = std::max(max, existing.size());
	}
	CHECK(max < 240); // A circle of 116 m and its edge, with 256 m² per tile.
	CHECK(existing.count({ 0, 0 }) == 0);
}

TEST_CASE("two cameras share near tiles, and without cameras nothing changes") {
	const std::vector<glm::vec2> places = { { 0.0f, 0.0f }, { 20.0f, 0.0f } };
	const TileChoice choice = choose_tiles({}, places, 30.0f, SIZE, EVERYWHERE);
	const std::set<TileKey> chosen(choice.to_load.begin(), choice.to_load.end());
	CHECK(chosen.size() == choice.to_load.size());
	const TileChoice none = choose_tiles(chosen, {}, 30.0f, SIZE, EVERYWHERE);
	CHECK(none.to_load.empty());
	CHECK(none.to_unload.empty());
	const TileChoice left = choose_tiles(chosen, { places[0] }, 30.0f, SIZE, EVERYWHERE);
	CHECK(left.to_load.empty());
	CHECK(choose_tiles(chosen, { { 900.0f, 0.0f } }, 30.0f, SIZE, EVERYWHERE).to_unload.size() == chosen.size());
}

TEST_CASE("no tiles are added outside of the area") {
	const AreaBox area = { { -10.0f, -10.0f }, { 10.0f, 10.0f } };
	CHECK(choose_tiles({}, { { 0.0f, 0.0f } }, 100.0f, SIZE, area).to_load.size() == 4);
	CHECK(choose_tiles({}, { { 500.0f, 0.0f } }, 100.0f, SIZE, area).to_load.empty());
	CHECK(choose_tiles({}, { { 0.0f, 500.0f } }, 100.0f, SIZE, area).to_load.empty());
	CHECK(choose_tiles({}, { { 100.0f, 5.0f } }, 100.0f, SIZE, area).to_load.size() == 2);
}

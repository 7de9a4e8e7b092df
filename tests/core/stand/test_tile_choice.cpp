#include "stand/tile_choice.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace undergrowth;

namespace {

constexpr float SIZE = 16.0f;
constexpr AreaBox EVERYWHERE = { { -1.0e5f, -1.0e5f }, { 1.0e5f, 1.0e5f } };

std::set<TileKey> after(std::set<TileKey> standing, const TileChoice &choice) {
	standing.insert(choice.coming.begin(), choice.coming.end());
	for (const TileKey &tile : choice.going) {
		standing.erase(tile);
	}
	return standing;
}

} // namespace

TEST_CASE("all tiles around a camera are added, nearest first") {
	const std::vector<glm::vec2> places = { { 5.0f, -7.0f } };
	const TileChoice choice = choose_tiles({}, places, 60.0f, SIZE, EVERYWHERE);
	CHECK(choice.going.empty());
	const std::set<TileKey> chosen(choice.coming.begin(), choice.coming.end());
	for (int column = -8; column <= 8; column++) {
		for (int row = -8; row <= 8; row++) {
			const bool is_near = distance_to_tile({ column, row }, SIZE, places) <= 60.0f;
			CHECK((chosen.count({ column, row }) > 0) == is_near);
		}
	}
	CHECK(choice.coming.front() == tile_at(5.0f, -7.0f, SIZE));
	CHECK(std::is_sorted(choice.coming.begin(), choice.coming.end(), [&](const TileKey &a, const TileKey &b) {
		return distance_to_tile(a, SIZE, places) < distance_to_tile(b, SIZE, places);
	}));
}

TEST_CASE("on a walk no tile is added and removed at once, and distant ones are removed") {
	std::set<TileKey> standing;
	std::size_t most = 0;
	for (int metre = 0; metre < 1000; metre++) {
		const std::vector<glm::vec2> places = { { static_cast<float>(metre), 3.0f } };
		const std::set<TileKey> next = after(standing, choose_tiles(standing, places, 100.0f, SIZE, EVERYWHERE));
		const TileChoice again = choose_tiles(next, places, 100.0f, SIZE, EVERYWHERE);
		REQUIRE(again.coming.empty());
		REQUIRE(again.going.empty());
		const TileChoice back = choose_tiles(next, { places[0] - glm::vec2(8.0f, 0.0f) }, 100.0f, SIZE, EVERYWHERE);
		REQUIRE(back.coming.size() < 8);
		standing = next;
		most = std::max(most, standing.size());
	}
	CHECK(most < 240); // A circle of 116 m and its edge, with 256 m² per tile.
	CHECK(standing.count({ 0, 0 }) == 0);
}

TEST_CASE("two cameras share near tiles, and without cameras nothing changes") {
	const std::vector<glm::vec2> places = { { 0.0f, 0.0f }, { 20.0f, 0.0f } };
	const TileChoice choice = choose_tiles({}, places, 30.0f, SIZE, EVERYWHERE);
	const std::set<TileKey> chosen(choice.coming.begin(), choice.coming.end());
	CHECK(chosen.size() == choice.coming.size());
	const TileChoice none = choose_tiles(chosen, {}, 30.0f, SIZE, EVERYWHERE);
	CHECK(none.coming.empty());
	CHECK(none.going.empty());
	const TileChoice left = choose_tiles(chosen, { places[0] }, 30.0f, SIZE, EVERYWHERE);
	CHECK(left.coming.empty());
	CHECK(choose_tiles(chosen, { { 900.0f, 0.0f } }, 30.0f, SIZE, EVERYWHERE).going.size() == chosen.size());
}

TEST_CASE("no tiles are added outside of the area") {
	const AreaBox area = { { -10.0f, -10.0f }, { 10.0f, 10.0f } };
	CHECK(choose_tiles({}, { { 0.0f, 0.0f } }, 100.0f, SIZE, area).coming.size() == 4);
	CHECK(choose_tiles({}, { { 500.0f, 0.0f } }, 100.0f, SIZE, area).coming.empty());
	CHECK(choose_tiles({}, { { 0.0f, 500.0f } }, 100.0f, SIZE, area).coming.empty());
	CHECK(choose_tiles({}, { { 100.0f, 5.0f } }, 100.0f, SIZE, area).coming.size() == 2);
}

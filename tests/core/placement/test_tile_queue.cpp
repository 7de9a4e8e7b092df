#include "placement/tile_queue.hpp"

#include <doctest/doctest.h>

using namespace undergrowth;

namespace {

constexpr float SIZE = 10.0f;

std::vector<TileKey> take_all(TileQueue &queue) {
	std::vector<TileKey> taken;
	while (!queue.is_empty()) {
		taken.push_back(queue.take());
	}
	return taken;
}

} // namespace

TEST_CASE("the tile nearest to any position comes first") {
	TileQueue queue;
	queue.set_places({ { 5.0f, 5.0f }, { 95.0f, 5.0f } }, SIZE);
	for (const TileKey &tile :
			{ TileKey{ 4, 0 }, TileKey{ 9, 0 }, TileKey{ 2, 0 }, TileKey{ 0, 0 }, TileKey{ 8, 0 } }) {
		queue.insert(tile);
	}
	CHECK(take_all(queue) == std::vector<TileKey>{ { 0, 0 }, { 9, 0 }, { 8, 0 }, { 2, 0 }, { 4, 0 } });
}

TEST_CASE("waiting tiles are ordered again when a position moves") {
	TileQueue queue;
	queue.set_places({ { 5.0f, 5.0f } }, SIZE);
	queue.insert({ 0, 0 });
	queue.insert({ 20, 0 });
	queue.set_places({ { 206.0f, 5.0f } }, SIZE);
	CHECK(queue.size() == 2);
	CHECK(queue.take() == TileKey{ 20, 0 });
}

TEST_CASE("a tile is in the queue once and can be removed") {
	TileQueue queue;
	queue.insert({ 1, 1 });
	queue.insert({ 1, 1 });
	queue.insert({ 2, 1 });
	CHECK(queue.size() == 2);
	CHECK(queue.contains({ 1, 1 }));
	queue.erase({ 1, 1 });
	queue.erase({ 7, 7 });
	CHECK_FALSE(queue.contains({ 1, 1 }));
	CHECK(queue.tiles() == std::vector<TileKey>{ { 2, 1 } });
	CHECK(take_all(queue) == std::vector<TileKey>{ { 2, 1 } });
}

TEST_CASE("without positions distances are measured to the origin") {
	TileQueue queue;
	queue.set_places({}, SIZE);
	queue.insert({ -5, 0 });
	queue.insert({ 1, 0 });
	CHECK(queue.take() == TileKey{ 1, 0 });
}

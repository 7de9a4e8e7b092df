#include "placement/tile_queue.hpp"

#include "placement/tile_choice.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace undergrowth {

namespace {

constexpr float NEAR_SHARE = 0.25f; ///< Of a tile. Nearer positions do not change the order.

} // namespace

void TileQueue::set_places(const std::vector<glm::vec2> &positions, float tile_size) {
	const std::vector<glm::vec2> wanted = positions.empty() ? std::vector<glm::vec2>(1, glm::vec2(0.0f)) : positions;
	const auto are_near = [&](const glm::vec2 &one, const glm::vec2 &other) {
		return glm::distance(one, other) < NEAR_SHARE * tile_size;
	};
	if (tile_size == size_of_tiles &&
			std::equal(wanted.begin(), wanted.end(), places.begin(), places.end(), are_near)) {
		return;
	}
	places = wanted;
	size_of_tiles = tile_size;
	const std::vector<TileKey> all = tiles();
	clear();
	for (const TileKey &tile : all) {
		insert(tile);
	}
}

void TileQueue::insert(const TileKey &tile) {
	const float away = distance_to_tile(tile, size_of_tiles, places);
	if (distances.emplace(tile, away).second) {
		ordered.emplace(away, tile);
	}
}

void TileQueue::erase(const TileKey &tile) {
	const auto found = distances.find(tile);
	if (found != distances.end()) {
		ordered.erase({ found->second, tile });
		distances.erase(found);
	}
}

void TileQueue::clear() {
	ordered.clear();
	distances.clear();
}

TileKey TileQueue::take() {
	const TileKey tile = ordered.begin()->second;
	erase(tile);
	return tile;
}

std::vector<TileKey> TileQueue::tiles() const {
	std::vector<TileKey> all;
	all.reserve(distances.size());
	for (const auto &entry : distances) {
		all.push_back(entry.first);
	}
	return all;
}

} // namespace undergrowth

#include "stand/tile_choice.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace undergrowth {

namespace {

/// Sorted by distance; tiles at equal distances are in tile order.
std::vector<TileKey> by_distance(std::vector<std::pair<float, TileKey>> &&tiles) {
	std::sort(tiles.begin(), tiles.end());
	std::vector<TileKey> sorted;
	sorted.reserve(tiles.size());
	for (const auto &entry : tiles) {
		sorted.push_back(entry.second);
	}
	return sorted;
}

} // namespace

float distance_to_tile(const TileKey &tile, float size, const std::vector<glm::vec2> &places) {
	const AreaBox box = tile_box(tile, size);
	float nearest = std::numeric_limits<float>::infinity();
	for (const glm::vec2 &place : places) {
		nearest = std::min(nearest, glm::distance(place, glm::clamp(place, box.low, box.high)));
	}
	return nearest;
}

TileChoice choose_tiles(const std::set<TileKey> &standing, const std::vector<glm::vec2> &places, float distance,
		float size, const AreaBox &area) {
	TileChoice choice;
	if (places.empty()) {
		return choice;
	}
	std::map<TileKey, float> near;
	for (const glm::vec2 &place : places) {
		const AreaBox around = common_box({ place - distance, place + distance }, area);
		const TileKey first = tile_at(around.low.x, around.low.y, size);
		const TileKey last = tile_at(around.high.x, around.high.y, size);
		for (int column = first.column; column <= last.column && around.low.y <= around.high.y; column++) {
			for (int row = first.row; row <= last.row; row++) {
				const TileKey tile = { column, row };
				if (standing.count(tile) == 0 && distance_to_tile(tile, size, { place }) <= distance) {
					near[tile] = distance_to_tile(tile, size, places);
				}
			}
		}
	}
	std::vector<std::pair<float, TileKey>> coming;
	for (const auto &[tile, away] : near) {
		coming.emplace_back(away, tile);
	}
	std::vector<std::pair<float, TileKey>> going;
	for (const TileKey &tile : standing) {
		const float away = distance_to_tile(tile, size, places);
		if (away > distance + size) {
			going.emplace_back(-away, tile);
		}
	}
	choice.coming = by_distance(std::move(coming));
	choice.going = by_distance(std::move(going));
	return choice;
}

} // namespace undergrowth

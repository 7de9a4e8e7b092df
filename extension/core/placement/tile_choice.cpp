#include "placement/tile_choice.hpp"

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

TileChoice choose_tiles(const std::set<TileKey> &existing, const std::vector<glm::vec2> &places, float distance,
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
				if (existing.count(tile) == 0 && distance_to_tile(tile, size, { place }) <= distance) {
					near[tile] = distance_to_tile(tile, size, places);
				}
			}
		}
	}
	std::vector<std::pair<float, TileKey>> to_load;
	for (const auto &[tile, away] : near) {
		to_load.emplace_back(away, tile);
	}
	std::vector<std::pair<float, TileKey>> to_unload;
	for (const TileKey &tile : existing) {
		const float away = distance_to_tile(tile, size, places);
		if (away > distance + size) {
			to_unload.emplace_back(-away, tile);
		}
	}
	choice.to_load = by_distance(std::move(to_load));
	choice.to_unload = by_distance(std::move(to_unload));
	return choice;
}

} // namespace undergrowth

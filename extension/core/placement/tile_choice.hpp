#pragma once

#include "placement/chunks.hpp"

#include <glm/vec2.hpp>

#include <set>
#include <vector>

namespace undergrowth {

/// Tiles to load and to unload, for a field that exists only around some positions.
struct TileChoice {
	std::vector<TileKey> to_load; ///< Nearest first.
	std::vector<TileKey> to_unload; ///< Farthest first.
};

/// m from the nearest of `places` to a tile of `size` (m); infinite without places.
float distance_to_tile(const TileKey &tile, float size, const std::vector<glm::vec2> &places);

/// Loads tiles of `size` (m) within `distance` (m) of a position that meet `area`, and unloads tiles more than one tile
/// beyond that distance; the hysteresis avoids repeated loading. Without positions nothing changes.
TileChoice choose_tiles(const std::set<TileKey> &existing, const std::vector<glm::vec2> &places, float distance,
		float size, const AreaBox &area);

} // namespace undergrowth

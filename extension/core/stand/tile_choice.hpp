#pragma once

#include "stand/blocks.hpp"

#include <glm/vec2.hpp>

#include <set>
#include <vector>

namespace undergrowth {

/// Of a field that stands around some places only: which tiles are to come, and which to go.
struct TileChoice {
	std::vector<TileKey> coming; ///< Nearest first.
	std::vector<TileKey> going; ///< Farthest first.
};

/// m from the nearest of some places to a tile of `size` (m); infinite where there are none.
float distance_to_tile(const TileKey &tile, float size, const std::vector<glm::vec2> &places);

/// Tiles of `size` (m) that are at most `distance` (m) from a place, and meet `area`, come unless they stand; those
/// that stand go where they are more than a tile farther than that, so that nobody comes and goes at once. No places at
/// all: everything stays as it is.
TileChoice choose_tiles(const std::set<TileKey> &standing, const std::vector<glm::vec2> &places, float distance,
		float size, const AreaBox &area);

} // namespace undergrowth

#pragma once

#include "placement/chunks.hpp"

#include <glm/vec2.hpp>

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace undergrowth {

/// Tiles to build, nearest to some positions first. Tiles at equal distances are in tile order.
class TileQueue {
public:
	/// Sets the positions (m) that distances are measured to, and the size of tiles (m). Without positions it measures
	/// to the origin. Positions that moved by less than a quarter of a tile change nothing.
	void set_places(const std::vector<glm::vec2> &positions, float tile_size);
	/// Adds a tile, once.
	void insert(const TileKey &tile);
	void erase(const TileKey &tile);
	void clear();
	/// Removes and returns the nearest tile of a queue that is not empty.
	TileKey take();

	bool contains(const TileKey &tile) const { return distances.count(tile) > 0; }
	bool is_empty() const { return ordered.empty(); }
	std::size_t size() const { return ordered.size(); }
	/// In tile order.
	std::vector<TileKey> tiles() const;

private:
	std::vector<glm::vec2> places = { { 0.0f, 0.0f } };
	float size_of_tiles = 16.0f; ///< m.
	std::set<std::pair<float, TileKey>> ordered;
	std::map<TileKey, float> distances;
};

} // namespace undergrowth

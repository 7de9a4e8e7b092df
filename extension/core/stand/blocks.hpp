#pragma once

#include "stand/area.hpp"
#include "stand/plants.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <tuple>
#include <vector>

namespace undergrowth {

/// A square of the ground: x from column·size to (column + 1)·size, z by `row` alike.
struct TileKey {
	int column = 0;
	int row = 0;

	bool operator<(const TileKey &other) const { return std::tie(column, row) < std::tie(other.column, other.row); }
	bool operator==(const TileKey &other) const { return column == other.column && row == other.row; }
};

/// The tile that holds (x, z) (m), of tiles of `size` (m). Whatever is farther than 1e9 tiles is in the last one.
TileKey tile_at(float x, float z, float size);

/// Where tile_at() is this one: on the lower sides included, on the others not.
AreaBox tile_box(const TileKey &tile, float size);

/// The tile that is `factor` (>= 1) times as wide and holds this one.
TileKey wider_tile(const TileKey &tile, int factor);

/// Plants of one species in one tile: what is built, stepped, drawn and dropped as a whole. Each keeps its slot for as
/// long as the block stands.
struct PlantBlock {
	static constexpr int MOST_PLANTS = 4096;
	/// Of a block of newcomers: so few that it is drawn anew in no time when more come.
	static constexpr int MOST_NEWCOMERS = 1024;

	TileKey tile;
	int species = 0;
	bool is_added = false; ///< By code, and not by filling.
	bool is_late = false; ///< Of newcomers among those that were filled; it grows.
	double spacing = 0.0; ///< m, of the placement that names its plants; of those that were added 0.
	FieldPlants plants; ///< By variant, where they were filled. A scale of 0 stands for a plant that is gone.
	std::vector<int64_t> ids; ///< Of plants that were added; those of others follow from where they stand.
	int gone = 0;
	glm::vec3 low = { 0.0f, 0.0f, 0.0f }; ///< m, the box around all roots.
	glm::vec3 high = { 0.0f, 0.0f, 0.0f };

	int size() const { return plants.size(); }
	/// How many it may have.
	int room() const { return is_late ? MOST_NEWCOMERS : MOST_PLANTS; }
	int standing() const { return plants.size() - gone; }
	bool is_gone(int slot) const { return plants.scale[static_cast<std::size_t>(slot)] == 0.0f; }
	glm::vec3 root(int slot) const {
		const auto at = static_cast<std::size_t>(slot);
		return { plants.x[at], plants.y[at], plants.z[at] };
	}
	/// Appends a valid plant. Its place widens the box.
	void add(const PlacedPlant &plant);
};

/// Cuts plants into blocks of tiles of `tile_size` (m; not above 0 acts as 16): along Hilbert's curve, so that
/// neighbours on the ground are neighbours in the list, then by species; within a block by variant. Equal ones stay in
/// their order.
std::vector<PlantBlock> cut_into_blocks(const FieldPlants &plants, float tile_size);

} // namespace undergrowth

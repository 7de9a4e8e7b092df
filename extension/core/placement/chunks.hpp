#pragma once

#include "placement/area.hpp"
#include "placement/plant_id.hpp"
#include "placement/plants.hpp"

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

/// The tile of `size` (m) that contains (x, z) (m). Positions beyond 1e9 tiles belong to the last one.
TileKey tile_at(float x, float z, float size);

/// The box of a tile: includes the lower sides, excludes the upper ones.
AreaBox tile_box(const TileKey &tile, float size);

/// The tile that is `factor` (>= 1) times as wide and contains this one.
TileKey wider_tile(const TileKey &tile, int factor);

/// Plants of one species in one tile: the unit of building, stepping, drawing and removal. The slot of a plant does not
/// change while the chunk exists.
struct PlantChunk {
	static constexpr int MAX_PLANTS = 4096;
	/// Maximum of a chunk of new plants: small, because it is redrawn when plants are added.
	static constexpr int MAX_NEW_PLANTS = 1024;

	TileKey tile;
	int species = 0;
	bool is_added = false; ///< Plants that code added.
	bool is_new = false; ///< Plants that a stroke or a path added to a built field; it grows.
	double spacing = 0.0; ///< m, of the placement that gives the ids; 0 for added plants.
	FieldPlants plants; ///< Generated plants are ordered by variant. A scale of 0 marks a removed plant.
	std::vector<PlantId> ids; ///< Ids of added plants; ids of generated plants follow from their position.
	int gone = 0;
	glm::vec3 low = { 0.0f, 0.0f, 0.0f }; ///< m, bounding box of all roots.
	glm::vec3 high = { 0.0f, 0.0f, 0.0f };

	int size() const { return plants.size(); }
	/// Maximum number of plants.
	int room() const { return is_new ? MAX_NEW_PLANTS : MAX_PLANTS; }
	int live_count() const { return plants.size() - gone; }
	bool is_gone(int slot) const { return plants.scale[static_cast<std::size_t>(slot)] == 0.0f; }
	glm::vec3 root(int slot) const {
		const auto at = static_cast<std::size_t>(slot);
		return { plants.x[at], plants.y[at], plants.z[at] };
	}
	PlantId id(int slot) const {
		const auto at = static_cast<std::size_t>(slot);
		return is_added ? ids[at] : generated_plant_id(plants.x[at], plants.z[at], spacing);
	}
	/// Appends a valid plant and extends the box.
	void add(const PlacedPlant &plant);
};

/// Cuts plants into chunks of tiles of `tile_size` (m; not above 0 acts as 16): along Hilbert's curve, so that
/// neighbours on the ground are neighbours in the list, then by species; within a chunk by variant. The sort is
/// stable.
std::vector<PlantChunk> cut_into_chunks(const FieldPlants &plants, float tile_size);

} // namespace undergrowth

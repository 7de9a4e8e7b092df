#pragma once

#include "stand/area.hpp"
#include "stand/blocks.hpp"
#include "stand/plant_id.hpp"

#include <cstddef>
#include <map>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace undergrowth {

/// Location of a plant in a store: stable while its block exists.
struct PlantPlace {
	int block = -1;
	int slot = -1;

	bool operator==(const PlantPlace &other) const { return block == other.block && slot == other.slot; }
	bool operator<(const PlantPlace &other) const { return std::tie(block, slot) < std::tie(other.block, other.slot); }
};

/// A change of a store. Its parts are applied in this order.
struct StandEdit {
	bool fills = false; ///< True: `filled` replaces all generated plants.
	std::vector<PlantBlock> filled; ///< Blocks from cut_into_blocks(), in tiles of `tile_size`.
	float tile_size = 16.0f; ///< m, > 0. A new size also re-divides added plants.
	double spacing = 0.0; ///< m, of the placement of `filled` or `stood`; 0: no change.
	/// With `fills`: new species by old species. Empty: no change.
	std::vector<int> species_numbers;
	/// New generated plants of the same placement: valid, in cells that are free or with a removed plant. Not
	/// together with `fills`.
	std::vector<PlacedPlant> grown;
	/// The same size: previous location of each plant that only changes its height, or a block of -1. Those are
	/// removed.
	std::vector<PlantPlace> grown_from;
	std::vector<PlantPlace> removed; ///< Existing plants. Not together with `fills`.
	/// Tiles whose generated plants are removed. Not together with `fills` or `grown`.
	std::vector<TileKey> left_tiles;
	/// New blocks in tiles without plants, including `left_tiles`.
	std::vector<PlantBlock> stood;
	std::vector<PlacedPlant> added; ///< Valid plants of species that the owner has.
	/// The same size, ascending: old, unused ids under which added plants are restored. Empty: new ids.
	std::vector<PlantId> added_ids;
};

/// Result of an edit, for simulation and rendering.
struct ChangeSet {
	/// Plants [first, size) of a block are new. In a new block first is 0.
	struct Grown {
		int block = 0;
		int first = 0;
	};

	/// A plant with a new location that continues its motion. `from` is also in `gone`, or its block in `dropped`.
	struct Moved {
		PlantPlace from;
		PlantPlace to;
	};

	std::vector<int> dropped; ///< Removed blocks. New blocks may reuse their numbers.
	std::vector<Grown> grown;
	/// Removed plants of blocks that still exist. A block of generated plants remains when it is empty; one of added
	/// plants is dropped.
	std::vector<PlantPlace> gone;
	/// Of StandEdit::grown. Their blocks grew before any block was dropped and do not reuse its number.
	std::vector<Moved> moved;
	std::vector<PlantId> added; ///< Ids in the order of StandEdit::added.
};

/// Generated plants with their locations.
struct StandingPlants {
	FieldPlants plants;
	std::vector<PlantPlace> places;
};

/// The plants of a field, in blocks by tile and species. Only apply() changes it. Locations are stable: a PlantPlace is
/// valid until a ChangeSet lists its block or plant.
class PlantStore {
public:
	ChangeSet apply(StandEdit &&edit);

	/// Upper bound of block numbers.
	int block_count() const { return static_cast<int>(blocks.size()); }
	/// An unused number has an empty block.
	const PlantBlock &block(int number) const { return blocks[static_cast<std::size_t>(number)]; }
	/// Ascending.
	const std::vector<int> &blocks_of(const TileKey &tile) const;
	float tile_size() const { return size; }
	/// m, of the placement of the latest generated plants. PlantBlock::spacing is that of each block: tiles without a
	/// rebuild can have another one.
	double spacing() const { return cell_size; }
	int plant_count() const { return standing; }

	/// True if generated plants at another spacing (m) have ids that differ from those of all existing plants.
	bool has_names_left(double other_spacing) const;

	/// Returns a block of -1 if there is no such plant. The cost depends on the plants of a tile.
	PlantPlace find(PlantId id) const;
	/// Tiles that may have generated plants.
	std::vector<TileKey> filled_tiles() const;
	/// Locations of those of the plants that exist, in the same order.
	std::vector<PlantPlace> find_all(const std::vector<PlantId> &ids) const;
	/// Id of an existing plant.
	PlantId id(const PlantPlace &place) const;
	/// Ids of all plants, in the order of blocks and slots.
	std::vector<PlantId> ids() const;
	/// Appends all plants with roots at most `radius` (m) from `centre`. The cost depends on the tiles that the
	/// sphere meets.
	void find_in_sphere(const glm::vec3 &centre, float radius, std::vector<PlantPlace> &found) const;
	/// The same within `radius` (m) of the line between two positions (x, z), seen from above, at any height.
	void find_along(const glm::vec2 &from, const glm::vec2 &to, float radius, std::vector<PlantPlace> &found) const;
	/// The same in a polygon (x, z), at any height.
	void find_in_polygon(const Polygon &polygon, std::vector<PlantPlace> &found) const;
	/// The plant with the root nearest to a position, within `radius` (m; may be infinite); a block of -1 if there is
	/// none. The cost depends on the tiles up to the nearest plant.
	PlantPlace find_nearest(const glm::vec3 &centre, float radius) const;
	/// Appends all plants with roots in the box, its faces included.
	void find_in_box(const glm::vec3 &low, const glm::vec3 &high, std::vector<PlantPlace> &found) const;

	/// All generated plants with roots in the box, its lower sides included, its upper sides excluded.
	StandingPlants filled_in(const AreaBox &box) const;

	/// Heap bytes, by capacity.
	std::size_t bytes() const;

private:
	float size = 16.0f; ///< m.
	double cell_size = 1.0; ///< m.
	std::map<double, int> spacings; ///< Number of generated blocks by spacing.
	std::vector<PlantBlock> blocks;
	std::vector<int> free_numbers;
	std::map<TileKey, std::vector<int>> tiles;
	std::unordered_map<PlantId, PlantPlace> added_places;
	int64_t next_added = 0;
	int standing = 0;

	int take_number();
	void stand(PlantBlock &&block, ChangeSet &changes);
	void drop(int number, ChangeSet &changes);
	void drop_filled(ChangeSet &changes);
	void leave(const TileKey &tile, ChangeSet &changes);
	void rename_species(const std::vector<int> &numbers);
	void cut_added_anew(ChangeSet &changes);
	void remove(const PlantPlace &place, ChangeSet &changes);
	void add(const PlacedPlant &plant, PlantId id, ChangeSet &changes);
	PlantPlace grow(const PlacedPlant &plant, ChangeSet &changes);
	PlantPlace find_filled(PlantId id, double at_spacing) const;
	int open_block(const TileKey &tile, int species, bool is_added) const;
	int need_block(const PlacedPlant &plant, bool is_added, ChangeSet &changes);
	template <class Visit> void for_each_tile(const glm::vec3 &low, const glm::vec3 &high, const Visit &visit) const;
	template <class Holds>
	void find_in(const glm::vec3 &low, const glm::vec3 &high, const Holds &holds, std::vector<PlantPlace> &found) const;
};

} // namespace undergrowth

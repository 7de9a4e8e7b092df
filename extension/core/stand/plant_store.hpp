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

/// Where a plant stands in a store: stable as long as its block stands.
struct PlantPlace {
	int block = -1;
	int slot = -1;

	bool operator==(const PlantPlace &other) const { return block == other.block && slot == other.slot; }
	bool operator<(const PlantPlace &other) const { return std::tie(block, slot) < std::tie(other.block, other.slot); }
};

/// What is to happen to a stand, in this order.
struct StandEdit {
	bool fills = false; ///< Whether `filled` replaces all plants that were filled before.
	std::vector<PlantBlock> filled; ///< As cut_into_blocks() makes them, of tiles of `tile_size`.
	float tile_size = 16.0f; ///< m, > 0. Another one than before cuts what was added anew, too.
	double spacing = 0.0; ///< m: of the placement that `filled` or `stood` comes from; 0: as before.
	/// With `fills`: what species are from now on, by what they were. Empty: the same.
	std::vector<int> species_numbers;
	/// Newcomers among those that were filled, of the same placement: valid ones, of cells where nobody stands, or
	/// where whoever does is removed. Not together with `fills`.
	std::vector<PlacedPlant> grown;
	/// As many: where each stood until now, otherwise high, or a block of -1. Those are removed.
	std::vector<PlantPlace> grown_from;
	std::vector<PlantPlace> removed; ///< Of plants that stand. Not together with `fills`.
	/// All plants that were filled in these tiles go, newcomers included. Not together with `fills` or `grown`.
	std::vector<TileKey> left_tiles;
	/// Stands beside what was filled before: as `filled`, in tiles where nobody is, those that were left included.
	std::vector<PlantBlock> stood;
	std::vector<PlacedPlant> added; ///< Valid ones, of species that the owner knows.
	/// As many, ascending: plants that were added before come back by their names, which nobody has. Empty: new names.
	std::vector<PlantId> added_ids;
};

/// What an edit did, for those who move and draw what stands.
struct ChangeSet {
	/// Plants [first, size) of a block are new. Of a block that is new, first is 0.
	struct Grown {
		int block = 0;
		int first = 0;
	};

	/// A plant that stands elsewhere now, and goes on with its motion. Those of `from` are gone or dropped as well.
	struct Moved {
		PlantPlace from;
		PlantPlace to;
	};

	std::vector<int> dropped; ///< Blocks that are no more. Their numbers may be those of new ones.
	std::vector<Grown> grown;
	/// Plants of blocks that still stand, even where nobody is left in one: only those that were added are dropped
	/// then.
	std::vector<PlantPlace> gone;
	/// Of StandEdit::grown. Their blocks grew before any was dropped, whose numbers they do not have.
	std::vector<Moved> moved;
	std::vector<PlantId> added; ///< As the edit's `added`, in its order.
};

/// Plants that were filled, with the place of each.
struct StandingPlants {
	FieldPlants plants;
	std::vector<PlantPlace> places;
};

/// The one place that knows what stands in a field: blocks of plants in square tiles. It changes by apply() only.
/// Plants never move within it: who was told a place may keep it until a ChangeSet names the block or the plant.
class PlantStore {
public:
	ChangeSet apply(StandEdit &&edit);

	/// One more than the largest number of a block.
	int block_count() const { return static_cast<int>(blocks.size()); }
	/// Where a number has no block, its block is empty.
	const PlantBlock &block(int number) const { return blocks[static_cast<std::size_t>(number)]; }
	/// Ascending.
	const std::vector<int> &blocks_of(const TileKey &tile) const;
	float tile_size() const { return size; }
	/// m, of the placement that plants were filled by last. PlantBlock::spacing says it of each: tiles that are yet to
	/// be grown anew may have another one.
	double spacing() const { return cell_size; }
	int plant_count() const { return standing; }

	/// Whether plants that are filled at another spacing (m) have other names than all who stand.
	bool has_names_left(double other_spacing) const;

	/// The block is -1 where no such plant stands. Costs by the plants of a tile.
	PlantPlace find(PlantId id) const;
	/// Tiles where somebody who was filled may stand.
	std::vector<TileKey> filled_tiles() const;
	/// Where those of them stand that do, in their order.
	std::vector<PlantPlace> find_all(const std::vector<PlantId> &ids) const;
	/// Of a plant that stands.
	PlantId id(const PlantPlace &place) const;
	/// Ids of all plants, in the order of blocks and slots.
	std::vector<PlantId> ids() const;
	/// Appends all plants whose roots are at most `radius` (m) from `centre`. Costs by the tiles that the sphere meets.
	void find_in_sphere(const glm::vec3 &centre, float radius, std::vector<PlantPlace> &found) const;
	/// The same at most `radius` (m) beside the line from one place (x, z) to another, seen from above, however high.
	void find_along(const glm::vec2 &from, const glm::vec2 &to, float radius, std::vector<PlantPlace> &found) const;
	/// The same in a polygon (x, z), however high.
	void find_in_polygon(const Polygon &polygon, std::vector<PlantPlace> &found) const;
	/// The plant whose root is nearest to a place, and at most `radius` (m, infinite ones too) from it; a block of -1
	/// where there is none. Costs by the tiles around the place, as far as the nearest plant is.
	PlantPlace find_nearest(const glm::vec3 &centre, float radius) const;
	/// Appends all plants whose roots are in the box, its faces included.
	void find_in_box(const glm::vec3 &low, const glm::vec3 &high, std::vector<PlantPlace> &found) const;

	/// All plants that were filled and have their roots in the box: on its lower sides included, on the others not.
	StandingPlants filled_in(const AreaBox &box) const;

	/// Of the heap, by capacity.
	std::size_t bytes() const;

private:
	float size = 16.0f; ///< m.
	double cell_size = 1.0; ///< m.
	std::map<double, int> spacings; ///< How many blocks that were filled have each.
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

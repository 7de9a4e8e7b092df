#pragma once

#include "placement/area.hpp"
#include "placement/chunks.hpp"
#include "placement/plant_id.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace undergrowth {

/// Location of a plant in a store: stable while its chunk exists.
struct PlantRef {
	int chunk = -1;
	int slot = -1;

	bool operator==(const PlantRef &other) const { return chunk == other.chunk && slot == other.slot; }
	bool operator<(const PlantRef &other) const { return std::tie(chunk, slot) < std::tie(other.chunk, other.slot); }
};

/// A change of a store. Its parts are applied in this order.
struct StoreEdit {
	bool replaces_all = false; ///< True: `generated` replaces all generated plants.
	std::vector<PlantChunk> generated; ///< Chunks from cut_into_chunks(), in tiles of `tile_size`.
	float tile_size = 16.0f; ///< m, > 0. A new size also re-divides added plants.
	double spacing = 0.0; ///< m, of the placement of `generated` or `arriving`; 0: no change.
	/// With `replaces_all`: new species by old species. Empty: no change.
	std::vector<int> species_numbers;
	/// New generated plants of the same placement: valid, in cells that are free or with a removed plant. Not
	/// together with `replaces_all`.
	std::vector<PlacedPlant> grown;
	/// The same size: previous location of each plant that only changes its height, or a chunk of -1. Those are
	/// removed.
	std::vector<PlantRef> grown_from;
	std::vector<PlantRef> removed; ///< Existing plants. Not together with `replaces_all`.
	/// Tiles whose generated plants are removed. Not together with `replaces_all` or `grown`.
	std::vector<TileKey> left_tiles;
	/// New chunks in tiles without plants, including `left_tiles`.
	std::vector<PlantChunk> arriving;
	std::vector<PlacedPlant> added; ///< Valid plants of species that the owner has.
	/// The same size, ascending: old, unused ids under which added plants are restored. Empty: new ids.
	std::vector<PlantId> added_ids;
};

/// Result of an edit, for simulation and rendering.
struct ChangeSet {
	/// Plants [first, size) of a chunk are new. In a new chunk first is 0.
	struct Grown {
		int chunk = 0;
		int first = 0;
	};

	/// A plant with a new location that continues its motion. `from` is also in `gone`, or its chunk in `dropped`.
	struct Moved {
		PlantRef from;
		PlantRef to;
	};

	std::vector<int> dropped; ///< Removed chunks. New chunks may reuse their numbers.
	/// Contents of removed chunks, so that another thread can free them.
	std::vector<std::shared_ptr<const PlantChunk>> left;
	std::vector<Grown> grown;
	/// Removed plants of chunks that still exist. A chunk of generated plants remains when it is empty; one of added
	/// plants is dropped.
	std::vector<PlantRef> gone;
	/// Of StoreEdit::grown. Their chunks grew before any chunk was dropped and do not reuse its number.
	std::vector<Moved> moved;
	std::vector<PlantId> added; ///< Ids in the order of StoreEdit::added.
};

/// Generated plants with their locations.
struct ExistingPlants {
	FieldPlants plants;
	std::vector<PlantRef> refs;
};

/// The plants of a field, in chunks by tile and species. Only apply() changes it. Locations are stable: a PlantRef is
/// valid until a ChangeSet lists its chunk or plant.
class PlantStore {
public:
	ChangeSet apply(StoreEdit &&edit);

	/// Upper bound of chunk numbers.
	int chunk_count() const { return static_cast<int>(chunks.size()); }
	/// An unused number has an empty chunk.
	const PlantChunk &chunk(int number) const { return *chunks[static_cast<std::size_t>(number)]; }
	/// The same for other threads: later edits do not change this chunk.
	std::shared_ptr<const PlantChunk> share(int number) const;
	/// Ascending.
	const std::vector<int> &chunks_of(const TileKey &tile) const;
	float tile_size() const { return size; }
	/// m, of the placement of the latest generated plants. PlantChunk::spacing is that of each chunk: tiles without a
	/// rebuild can have another one.
	double spacing() const { return cell_size; }
	int plant_count() const { return plant_total; }

	/// True if generated plants at another spacing (m) have ids that differ from those of all existing plants.
	bool has_unused_ids(double other_spacing) const;

	/// Returns a chunk of -1 if there is no such plant. The cost depends on the plants of a tile.
	PlantRef find(PlantId id) const;
	/// Tiles that may have generated plants.
	std::vector<TileKey> generated_tiles() const;
	/// Locations of those of the plants that exist, in the same order.
	std::vector<PlantRef> find_all(const std::vector<PlantId> &ids) const;
	/// Id of an existing plant.
	PlantId id(const PlantRef &ref) const;
	/// Ids of all plants. Their order does not depend on the order in which tiles were built.
	std::vector<PlantId> ids() const;
	/// Appends all plants with roots at most `radius` (m) from `centre`. The cost depends on the tiles that the
	/// sphere meets.
	void find_in_sphere(const glm::vec3 &centre, float radius, std::vector<PlantRef> &found) const;
	/// The same within `radius` (m) of the line between two positions (x, z), seen from above, at any height.
	void find_along(const glm::vec2 &from, const glm::vec2 &to, float radius, std::vector<PlantRef> &found) const;
	/// The same in a polygon (x, z), at any height.
	void find_in_polygon(const Polygon &polygon, std::vector<PlantRef> &found) const;
	/// The plant with the root nearest to a position, within `radius` (m; may be infinite); a chunk of -1 if there is
	/// none. The cost depends on the tiles up to the nearest plant.
	PlantRef find_nearest(const glm::vec3 &centre, float radius) const;
	/// Appends all plants with roots in the box, its faces included.
	void find_in_box(const glm::vec3 &low, const glm::vec3 &high, std::vector<PlantRef> &found) const;

	/// All generated plants with roots in the box, its lower sides included, its upper sides excluded.
	ExistingPlants generated_in(const AreaBox &box) const;

	/// Heap bytes, by capacity.
	std::size_t bytes() const;

private:
	float size = 16.0f; ///< m.
	double cell_size = 1.0; ///< m.
	std::map<double, int> spacings; ///< Number of generated chunks by spacing.
	std::vector<std::shared_ptr<PlantChunk>> chunks;
	mutable std::unordered_set<int> shared_chunks; ///< Chunks that share() returned and that have not changed since.
	std::vector<int> free_numbers;
	std::map<TileKey, std::vector<int>> tiles;
	std::unordered_map<PlantId, PlantRef> added_refs;
	int64_t next_added = 0;
	int plant_total = 0;

	/// Returns the chunk for a change. Copies it first if share() returned it.
	PlantChunk &own(int number);
	int take_number();
	std::vector<int> ordered_chunks() const;
	void insert(PlantChunk &&chunk, ChangeSet &changes);
	void drop(int number, ChangeSet &changes);
	void drop_generated(ChangeSet &changes);
	void leave(const TileKey &tile, ChangeSet &changes);
	void rename_species(const std::vector<int> &numbers);
	void recut_added(ChangeSet &changes);
	void remove(const PlantRef &ref, ChangeSet &changes);
	void add(const PlacedPlant &plant, PlantId id, ChangeSet &changes);
	PlantRef grow(const PlacedPlant &plant, ChangeSet &changes);
	PlantRef find_generated(PlantId id, double at_spacing) const;
	int open_chunk(const TileKey &tile, int species, bool is_added) const;
	int need_chunk(const PlacedPlant &plant, bool is_added, ChangeSet &changes);
	template <class Visit> void for_each_tile(const glm::vec3 &low, const glm::vec3 &high, const Visit &visit) const;
	template <class Holds>
	void find_in(const glm::vec3 &low, const glm::vec3 &high, const Holds &holds, std::vector<PlantRef> &found) const;
};

} // namespace undergrowth

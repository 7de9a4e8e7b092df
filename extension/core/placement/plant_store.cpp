// PlantStore: application of edits. plant_store_queries.cpp has the queries.

#include "placement/plant_store.hpp"

#include <glm/vec3.hpp>

#include <algorithm>
#include <utility>

namespace undergrowth {

ChangeSet PlantStore::apply(StoreEdit &&edit) {
	ChangeSet changes;
	cell_size = edit.spacing > 0.0 ? edit.spacing : cell_size;
	if (edit.replaces_all) {
		drop_generated(changes);
		rename_species(edit.species_numbers);
		const bool is_recut = edit.tile_size != size;
		size = edit.tile_size;
		for (PlantChunk &chunk : edit.generated) {
			insert(std::move(chunk), changes);
		}
		if (is_recut) {
			recut_added(changes);
		}
	}
	for (std::size_t i = 0; i < edit.grown.size(); i++) {
		const PlantRef ref = grow(edit.grown[i], changes);
		if (edit.grown_from[i].chunk >= 0) {
			changes.moved.push_back({ edit.grown_from[i], ref });
		}
	}
	for (const ChangeSet::Moved &plant : changes.moved) {
		remove(plant.from, changes);
	}
	for (const PlantRef &ref : edit.removed) {
		remove(ref, changes);
	}
	// If an edit removes the last plant of a chunk, the chunk is reported and its earlier removals are not.
	const auto is_empty = [this](const PlantRef &ref) { return chunk(ref.chunk).size() == 0; };
	changes.gone.erase(std::remove_if(changes.gone.begin(), changes.gone.end(), is_empty), changes.gone.end());
	for (const TileKey &tile : edit.left_tiles) {
		leave(tile, changes);
	}
	for (PlantChunk &chunk : edit.arriving) {
		insert(std::move(chunk), changes);
	}
	for (std::size_t i = 0; i < edit.added.size(); i++) {
		const PlantId id = i < edit.added_ids.size() ? edit.added_ids[i] : added_plant_id(next_added);
		next_added = std::max(next_added, added_plant_number(id) + 1);
		changes.added.push_back(id);
		add(edit.added[i], id, changes);
	}
	return changes;
}

int PlantStore::take_number() {
	if (free_numbers.empty()) {
		chunks.emplace_back();
		return chunk_count() - 1;
	}
	const int number = free_numbers.back();
	free_numbers.pop_back();
	return number;
}

void PlantStore::insert(PlantChunk &&chunk, ChangeSet &changes) {
	const int number = take_number();
	plant_total += chunk.live_count();
	chunk.spacing = cell_size;
	spacings[cell_size]++;
	tiles[chunk.tile].push_back(number);
	chunks[static_cast<std::size_t>(number)] = std::move(chunk);
	changes.grown.push_back({ number, 0 });
}

void PlantStore::drop(int number, ChangeSet &changes) {
	PlantChunk &chunk = chunks[static_cast<std::size_t>(number)];
	const auto tile = tiles.find(chunk.tile);
	std::vector<int> &members = tile->second;
	members.erase(std::find(members.begin(), members.end(), number));
	if (members.empty()) {
		tiles.erase(tile);
	}
	for (const PlantId id : chunk.ids) {
		added_refs.erase(id);
	}
	plant_total -= chunk.live_count();
	const auto same = spacings.find(chunk.spacing);
	if (same != spacings.end() && --same->second == 0) {
		spacings.erase(same);
	}
	chunk = PlantChunk();
	free_numbers.push_back(number);
	changes.dropped.push_back(number);
}

void PlantStore::drop_generated(ChangeSet &changes) {
	// From the last, so that take_number() returns the lowest first and an equal rebuild has equal numbers.
	for (int number = chunk_count() - 1; number >= 0; number--) {
		if (chunk(number).size() > 0 && !chunk(number).is_added) {
			drop(number, changes);
		}
	}
}

void PlantStore::leave(const TileKey &tile, ChangeSet &changes) {
	const std::vector<int> members = chunks_of(tile);
	for (const int number : members) {
		if (!chunk(number).is_added) {
			drop(number, changes);
		}
	}
}

void PlantStore::rename_species(const std::vector<int> &numbers) {
	for (PlantChunk &chunk : chunks) {
		if (!chunk.is_added || numbers.empty()) {
			continue;
		}
		chunk.species = numbers[static_cast<std::size_t>(chunk.species)];
		std::fill(chunk.plants.species.begin(), chunk.plants.species.end(), static_cast<uint8_t>(chunk.species));
	}
}

/// Moves added plants to their new tiles. Ids do not change.
void PlantStore::recut_added(ChangeSet &changes) {
	std::vector<std::pair<PlantId, PlacedPlant>> kept;
	for (int number = 0; number < chunk_count(); number++) {
		const PlantChunk &old = chunk(number);
		if (!old.is_added) {
			continue;
		}
		for (int slot = 0; slot < old.size(); slot++) {
			if (!old.is_gone(slot)) {
				kept.emplace_back(old.ids[static_cast<std::size_t>(slot)], old.plants.plant(slot));
			}
		}
		drop(number, changes);
	}
	for (const auto &[id, plant] : kept) {
		add(plant, id, changes);
	}
}

void PlantStore::remove(const PlantRef &ref, ChangeSet &changes) {
	PlantChunk &chunk = chunks[static_cast<std::size_t>(ref.chunk)];
	if (chunk.size() == 0 || chunk.is_gone(ref.slot)) {
		return;
	}
	if (chunk.is_added) {
		added_refs.erase(chunk.ids[static_cast<std::size_t>(ref.slot)]);
	}
	if ((chunk.is_added || chunk.is_new) && chunk.live_count() == 1) {
		drop(ref.chunk, changes);
		return;
	}
	chunk.plants.scale[static_cast<std::size_t>(ref.slot)] = 0.0f;
	chunk.gone++;
	plant_total--;
	changes.gone.push_back(ref);
}

/// Chunk of added plants, or of new ones, of a species in a tile that has room, or -1.
int PlantStore::open_chunk(const TileKey &tile, int species, bool is_added) const {
	for (const int number : chunks_of(tile)) {
		const PlantChunk &there = chunk(number);
		const bool is_such = is_added ? there.is_added : there.is_new && there.spacing == cell_size;
		if (is_such && there.species == species && there.size() < there.room()) {
			return number;
		}
	}
	return -1;
}

/// Chunk to append a plant to.
int PlantStore::need_chunk(const PlacedPlant &plant, bool is_added, ChangeSet &changes) {
	const TileKey tile = tile_at(plant.root.x, plant.root.z, size);
	int number = open_chunk(tile, plant.species, is_added);
	if (number < 0) {
		number = take_number();
		PlantChunk &fresh = chunks[static_cast<std::size_t>(number)];
		fresh.tile = tile;
		fresh.species = plant.species;
		fresh.is_added = is_added;
		fresh.is_new = !is_added;
		if (!is_added) {
			fresh.spacing = cell_size;
			spacings[cell_size]++;
		}
		tiles[tile].push_back(number);
	}
	const auto is_known = [number](const ChangeSet::Grown &grown) { return grown.chunk == number; };
	if (std::none_of(changes.grown.rbegin(), changes.grown.rend(), is_known)) {
		changes.grown.push_back({ number, chunk(number).size() });
	}
	return number;
}

void PlantStore::add(const PlacedPlant &plant, PlantId id, ChangeSet &changes) {
	const int number = need_chunk(plant, true, changes);
	PlantChunk &into = chunks[static_cast<std::size_t>(number)];
	into.add(plant);
	into.ids.push_back(id);
	added_refs[id] = { number, into.size() - 1 };
	plant_total++;
}

PlantRef PlantStore::grow(const PlacedPlant &plant, ChangeSet &changes) {
	const int number = need_chunk(plant, false, changes);
	PlantChunk &into = chunks[static_cast<std::size_t>(number)];
	into.add(plant);
	plant_total++;
	return { number, into.size() - 1 };
}

} // namespace undergrowth

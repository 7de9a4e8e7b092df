// PlantStore: application of edits. plant_store_questions.cpp has the queries.

#include "stand/plant_store.hpp"

#include <glm/vec3.hpp>

#include <algorithm>
#include <utility>

namespace undergrowth {

ChangeSet PlantStore::apply(StandEdit &&edit) {
	ChangeSet changes;
	cell_size = edit.spacing > 0.0 ? edit.spacing : cell_size;
	if (edit.fills) {
		drop_filled(changes);
		rename_species(edit.species_numbers);
		const bool is_cut_anew = edit.tile_size != size;
		size = edit.tile_size;
		for (PlantBlock &block : edit.filled) {
			stand(std::move(block), changes);
		}
		if (is_cut_anew) {
			cut_added_anew(changes);
		}
	}
	for (std::size_t i = 0; i < edit.grown.size(); i++) {
		const PlantPlace place = grow(edit.grown[i], changes);
		if (edit.grown_from[i].block >= 0) {
			changes.moved.push_back({ edit.grown_from[i], place });
		}
	}
	for (const ChangeSet::Moved &plant : changes.moved) {
		remove(plant.from, changes);
	}
	for (const PlantPlace &place : edit.removed) {
		remove(place, changes);
	}
	// If an edit removes the last plant of a block, the block is reported and its earlier removals are not.
	const auto is_empty = [this](const PlantPlace &place) { return block(place.block).size() == 0; };
	changes.gone.erase(std::remove_if(changes.gone.begin(), changes.gone.end(), is_empty), changes.gone.end());
	for (const TileKey &tile : edit.left_tiles) {
		leave(tile, changes);
	}
	for (PlantBlock &block : edit.stood) {
		stand(std::move(block), changes);
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
		blocks.emplace_back();
		return block_count() - 1;
	}
	const int number = free_numbers.back();
	free_numbers.pop_back();
	return number;
}

void PlantStore::stand(PlantBlock &&block, ChangeSet &changes) {
	const int number = take_number();
	standing += block.standing();
	block.spacing = cell_size;
	spacings[cell_size]++;
	tiles[block.tile].push_back(number);
	blocks[static_cast<std::size_t>(number)] = std::move(block);
	changes.grown.push_back({ number, 0 });
}

void PlantStore::drop(int number, ChangeSet &changes) {
	PlantBlock &block = blocks[static_cast<std::size_t>(number)];
	const auto tile = tiles.find(block.tile);
	std::vector<int> &members = tile->second;
	members.erase(std::find(members.begin(), members.end(), number));
	if (members.empty()) {
		tiles.erase(tile);
	}
	for (const PlantId id : block.ids) {
		added_places.erase(id);
	}
	standing -= block.standing();
	const auto same = spacings.find(block.spacing);
	if (same != spacings.end() && --same->second == 0) {
		spacings.erase(same);
	}
	block = PlantBlock();
	free_numbers.push_back(number);
	changes.dropped.push_back(number);
}

void PlantStore::drop_filled(ChangeSet &changes) {
	// From the last, so that take_number() returns the lowest first and an equal rebuild has equal numbers.
	for (int number = block_count() - 1; number >= 0; number--) {
		if (block(number).size() > 0 && !block(number).is_added) {
			drop(number, changes);
		}
	}
}

void PlantStore::leave(const TileKey &tile, ChangeSet &changes) {
	const std::vector<int> members = blocks_of(tile);
	for (const int number : members) {
		if (!block(number).is_added) {
			drop(number, changes);
		}
	}
}

void PlantStore::rename_species(const std::vector<int> &numbers) {
	for (PlantBlock &block : blocks) {
		if (!block.is_added || numbers.empty()) {
			continue;
		}
		block.species = numbers[static_cast<std::size_t>(block.species)];
		std::fill(block.plants.species.begin(), block.plants.species.end(), static_cast<uint8_t>(block.species));
	}
}

/// Moves added plants to their new tiles. Ids do not change.
void PlantStore::cut_added_anew(ChangeSet &changes) {
	std::vector<std::pair<PlantId, PlacedPlant>> kept;
	for (int number = 0; number < block_count(); number++) {
		const PlantBlock &old = block(number);
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

void PlantStore::remove(const PlantPlace &place, ChangeSet &changes) {
	PlantBlock &block = blocks[static_cast<std::size_t>(place.block)];
	if (block.size() == 0 || block.is_gone(place.slot)) {
		return;
	}
	if (block.is_added) {
		added_places.erase(block.ids[static_cast<std::size_t>(place.slot)]);
	}
	if ((block.is_added || block.is_late) && block.standing() == 1) {
		drop(place.block, changes);
		return;
	}
	block.plants.scale[static_cast<std::size_t>(place.slot)] = 0.0f;
	block.gone++;
	standing--;
	changes.gone.push_back(place);
}

/// Block of added plants, or of late ones, of a species in a tile that has room, or -1.
int PlantStore::open_block(const TileKey &tile, int species, bool is_added) const {
	for (const int number : blocks_of(tile)) {
		const PlantBlock &there = block(number);
		const bool is_such = is_added ? there.is_added : there.is_late && there.spacing == cell_size;
		if (is_such && there.species == species && there.size() < there.room()) {
			return number;
		}
	}
	return -1;
}

/// Block to append a plant to.
int PlantStore::need_block(const PlacedPlant &plant, bool is_added, ChangeSet &changes) {
	const TileKey tile = tile_at(plant.root.x, plant.root.z, size);
	int number = open_block(tile, plant.species, is_added);
	if (number < 0) {
		number = take_number();
		PlantBlock &fresh = blocks[static_cast<std::size_t>(number)];
		fresh.tile = tile;
		fresh.species = plant.species;
		fresh.is_added = is_added;
		fresh.is_late = !is_added;
		if (!is_added) {
			fresh.spacing = cell_size;
			spacings[cell_size]++;
		}
		tiles[tile].push_back(number);
	}
	const auto is_known = [number](const ChangeSet::Grown &grown) { return grown.block == number; };
	if (std::none_of(changes.grown.rbegin(), changes.grown.rend(), is_known)) {
		changes.grown.push_back({ number, block(number).size() });
	}
	return number;
}

void PlantStore::add(const PlacedPlant &plant, PlantId id, ChangeSet &changes) {
	const int number = need_block(plant, true, changes);
	PlantBlock &into = blocks[static_cast<std::size_t>(number)];
	into.add(plant);
	into.ids.push_back(id);
	added_places[id] = { number, into.size() - 1 };
	standing++;
}

PlantPlace PlantStore::grow(const PlacedPlant &plant, ChangeSet &changes) {
	const int number = need_block(plant, false, changes);
	PlantBlock &into = blocks[static_cast<std::size_t>(number)];
	into.add(plant);
	standing++;
	return { number, into.size() - 1 };
}

} // namespace undergrowth

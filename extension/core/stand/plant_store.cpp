#include "stand/plant_store.hpp"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace undergrowth {

namespace {

bool is_in(const glm::vec3 &point, const glm::vec3 &low, const glm::vec3 &high) {
	return point.x >= low.x && point.x <= high.x && point.y >= low.y && point.y <= high.y && point.z >= low.z &&
			point.z <= high.z;
}

bool meet(const PlantBlock &block, const glm::vec3 &low, const glm::vec3 &high) {
	return block.low.x <= high.x && block.high.x >= low.x && block.low.y <= high.y && block.high.y >= low.y &&
			block.low.z <= high.z && block.high.z >= low.z;
}

bool is_near(const PlantBlock &block, const glm::vec3 &place, float reach) {
	return block.low.x <= place.x + reach && block.high.x >= place.x - reach && block.low.z <= place.z + reach &&
			block.high.z >= place.z - reach;
}

} // namespace

ChangeSet PlantStore::apply(StandEdit &&edit) {
	ChangeSet changes;
	if (edit.fills) {
		drop_filled(changes);
		rename_species(edit.species_numbers);
		const bool is_cut_anew = edit.tile_size != size;
		size = edit.tile_size;
		cell_size = edit.spacing;
		for (PlantBlock &block : edit.filled) {
			stand(std::move(block), changes);
		}
		if (is_cut_anew) {
			cut_added_anew(changes);
		}
	}
	for (const PlantPlace &place : edit.removed) {
		remove(place, changes);
	}
	// Whoever went before the last one of a block is told of with it.
	const auto is_empty = [this](const PlantPlace &place) { return block(place.block).size() == 0; };
	changes.gone.erase(std::remove_if(changes.gone.begin(), changes.gone.end(), is_empty), changes.gone.end());
	for (const PlacedPlant &plant : edit.added) {
		changes.added.push_back(added_plant_id(next_added++));
		add(plant, changes.added.back(), changes);
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
	block = PlantBlock();
	free_numbers.push_back(number);
	changes.dropped.push_back(number);
}

void PlantStore::drop_filled(ChangeSet &changes) {
	// From the last, so that take_number() gives the lowest first: a field that is filled as before keeps its numbers.
	for (int number = block_count() - 1; number >= 0; number--) {
		if (block(number).size() > 0 && !block(number).is_added) {
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

/// Their tiles are others now. Names stay.
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
	if (block.is_added && block.standing() == 1) {
		drop(place.block, changes);
		return;
	}
	block.plants.scale[static_cast<std::size_t>(place.slot)] = 0.0f;
	block.gone++;
	standing--;
	changes.gone.push_back(place);
}

/// The block of added plants of a species in a tile that has room, or -1.
int PlantStore::open_block(const TileKey &tile, int species) const {
	for (const int number : blocks_of(tile)) {
		const PlantBlock &there = block(number);
		if (there.is_added && there.species == species && there.size() < PlantBlock::MOST_PLANTS) {
			return number;
		}
	}
	return -1;
}

void PlantStore::add(const PlacedPlant &plant, PlantId id, ChangeSet &changes) {
	const TileKey tile = tile_at(plant.root.x, plant.root.z, size);
	int number = open_block(tile, plant.species);
	if (number < 0) {
		number = take_number();
		PlantBlock &fresh = blocks[static_cast<std::size_t>(number)];
		fresh.tile = tile;
		fresh.species = plant.species;
		fresh.is_added = true;
		tiles[tile].push_back(number);
	}
	PlantBlock &into = blocks[static_cast<std::size_t>(number)];
	const auto is_known = [number](const ChangeSet::Grown &grown) { return grown.block == number; };
	if (std::none_of(changes.grown.rbegin(), changes.grown.rend(), is_known)) {
		changes.grown.push_back({ number, into.size() });
	}
	into.add(plant);
	into.ids.push_back(id);
	added_places[id] = { number, into.size() - 1 };
	standing++;
}

const std::vector<int> &PlantStore::blocks_of(const TileKey &tile) const {
	static const std::vector<int> none;
	const auto found = tiles.find(tile);
	return found == tiles.end() ? none : found->second;
}

template <class Visit>
void PlantStore::for_each_tile(const glm::vec3 &low, const glm::vec3 &high, const Visit &visit) const {
	const TileKey first = tile_at(low.x, low.z, size);
	const TileKey last = tile_at(high.x, high.z, size);
	for (auto tile = tiles.lower_bound(first); tile != tiles.end() && tile->first.column <= last.column; ++tile) {
		if (tile->first.row >= first.row && tile->first.row <= last.row) {
			visit(tile->second);
		}
	}
}

template <class Holds>
void PlantStore::find_in(
		const glm::vec3 &low, const glm::vec3 &high, const Holds &holds, std::vector<PlantPlace> &found) const {
	for_each_tile(low, high, [&](const std::vector<int> &members) {
		for (const int number : members) {
			const PlantBlock &there = block(number);
			for (int slot = 0; meet(there, low, high) && slot < there.size(); slot++) {
				if (!there.is_gone(slot) && holds(there.root(slot))) {
					found.push_back({ number, slot });
				}
			}
		}
	});
}

void PlantStore::find_in_sphere(const glm::vec3 &centre, float radius, std::vector<PlantPlace> &found) const {
	if (!(radius >= 0.0f)) {
		return;
	}
	const double most = static_cast<double>(radius) * static_cast<double>(radius);
	const auto holds = [&](const glm::vec3 &root) {
		const glm::dvec3 way = glm::dvec3(root) - glm::dvec3(centre);
		return way.x * way.x + way.y * way.y + way.z * way.z <= most;
	};
	find_in(centre - radius, centre + radius, holds, found);
}

void PlantStore::find_in_box(const glm::vec3 &low, const glm::vec3 &high, std::vector<PlantPlace> &found) const {
	find_in(low, high, [&](const glm::vec3 &root) { return is_in(root, low, high); }, found);
}

PlantPlace PlantStore::find(PlantId id) const {
	if (id < 0) {
		return {};
	}
	if (undergrowth::is_added(id)) {
		const auto found = added_places.find(id);
		return found == added_places.end() ? PlantPlace() : found->second;
	}
	glm::vec3 place(0.0f);
	filled_plant_place(id, cell_size, place.x, place.z);
	const float reach = static_cast<float>(cell_size);
	PlantPlace found;
	for_each_tile(place - reach, place + reach, [&](const std::vector<int> &members) {
		for (const int number : members) {
			const PlantBlock &there = block(number);
			if (found.block >= 0 || there.is_added || !is_near(there, place, reach)) {
				continue;
			}
			const float *x = there.plants.x.data();
			const float *z = there.plants.z.data();
			for (int slot = 0; slot < there.size(); slot++) {
				// Most are too far: the exact answer costs a division.
				if (std::fabs(x[slot] - place.x) < reach && std::fabs(z[slot] - place.z) < reach &&
						!there.is_gone(slot) && filled_plant_id(x[slot], z[slot], cell_size) == id) {
					found = { number, slot };
					break;
				}
			}
		}
	});
	return found;
}

PlantId PlantStore::id(const PlantPlace &place) const {
	const PlantBlock &there = block(place.block);
	if (there.is_added) {
		return there.ids[static_cast<std::size_t>(place.slot)];
	}
	const glm::vec3 root = there.root(place.slot);
	return filled_plant_id(root.x, root.z, cell_size);
}

std::vector<PlantId> PlantStore::ids() const {
	std::vector<PlantId> all;
	all.reserve(static_cast<std::size_t>(standing));
	for (int number = 0; number < block_count(); number++) {
		for (int slot = 0; slot < block(number).size(); slot++) {
			if (!block(number).is_gone(slot)) {
				all.push_back(id({ number, slot }));
			}
		}
	}
	return all;
}

std::size_t PlantStore::bytes() const {
	std::size_t bytes = blocks.capacity() * sizeof(PlantBlock);
	for (const PlantBlock &block : blocks) {
		bytes += block.plants.bytes() + block.ids.capacity() * sizeof(PlantId);
	}
	return bytes;
}

} // namespace undergrowth

#include "stand/kept_plants.hpp"

#include "base/random.hpp"

#include <algorithm>
#include <numeric>

namespace undergrowth {

namespace {

PlantId name_of(const PlantBlock &block, int slot, double spacing) {
	const glm::vec3 root = block.root(slot);
	return filled_plant_id(root.x, root.z, spacing);
}

FilledBlocks copy_of(const PlantStore &store, const std::vector<int> &numbers) {
	FilledBlocks filled;
	filled.spacing = store.spacing();
	for (const int number : numbers) {
		const PlantBlock &block = store.block(number);
		if (!block.is_added && block.standing() > 0) {
			filled.blocks.emplace_back(number, block);
		}
	}
	return filled;
}

/// Whether the same plants stand as before, as after most changes: no names need be compared then.
bool are_the_same(const FilledBlocks &before, const std::vector<PlantBlock> &now, double spacing) {
	return std::equal(now.begin(), now.end(), before.blocks.begin(), before.blocks.end(),
			[spacing](const PlantBlock &block, const std::pair<int, PlantBlock> &was) {
				return was.second.spacing == spacing && was.second.gone == 0 && block.plants.x == was.second.plants.x &&
						block.plants.z == was.second.plants.z;
			});
}

/// Where plants of different names stand: a hash table with open addressing, at most half full.
class PlacesByName {
public:
	explicit PlacesByName(std::size_t count) {
		while (last < 2 * count) {
			last = 2 * last + 1;
		}
		entries.resize(last + 1, { NOBODY, {} });
	}

	void add(PlantId name, const PlantPlace &place) { entries[slot_of(name)] = { name, place }; }

	const PlantPlace *find(PlantId name) const {
		const auto &entry = entries[slot_of(name)];
		return entry.first == name ? &entry.second : nullptr;
	}

private:
	static constexpr PlantId NOBODY = -1;
	std::size_t last = 1; ///< All bits below a power of two.
	std::vector<std::pair<PlantId, PlantPlace>> entries;

	/// Where a name stands, or would.
	std::size_t slot_of(PlantId name) const {
		std::size_t slot = mix_bits(static_cast<uint64_t>(name)) & last;
		while (entries[slot].first != name && entries[slot].first != NOBODY) {
			slot = (slot + 1) & last;
		}
		return slot;
	}
};

} // namespace

FilledBlocks copy_filled(const PlantStore &store) {
	std::vector<int> numbers(static_cast<std::size_t>(store.block_count()));
	std::iota(numbers.begin(), numbers.end(), 0);
	return copy_of(store, numbers);
}

FilledBlocks copy_filled_in(const PlantStore &store, const TileKey &tile) {
	return copy_of(store, store.blocks_of(tile));
}

FieldPlants gather_plants(const FilledBlocks &filled, const std::vector<int> &species_numbers) {
	FieldPlants plants;
	for (const auto &[number, block] : filled.blocks) {
		const int species = species_numbers[static_cast<std::size_t>(block.species)];
		for (int slot = 0; slot < block.size() && species >= 0; slot++) {
			if (!block.is_gone(slot)) {
				PlacedPlant plant = block.plants.plant(slot);
				plant.species = species;
				plants.add(plant);
			}
		}
	}
	return plants;
}

std::vector<KeptPlant> find_kept(const FilledBlocks &before, const std::vector<PlantBlock> &now, double spacing) {
	std::vector<KeptPlant> kept;
	if (are_the_same(before, now, spacing)) {
		for (std::size_t i = 0; i < now.size(); i++) {
			for (int slot = 0; slot < now[i].size(); slot++) {
				kept.push_back({ { before.blocks[i].first, slot }, { static_cast<int>(i), slot } });
			}
		}
		return kept;
	}
	std::size_t count = 0;
	for (const auto &[number, block] : before.blocks) {
		count += block.spacing == spacing ? static_cast<std::size_t>(block.size()) : 0;
	}
	PlacesByName named(count);
	for (const auto &[number, block] : before.blocks) {
		for (int slot = 0; block.spacing == spacing && slot < block.size(); slot++) {
			if (!block.is_gone(slot)) {
				named.add(name_of(block, slot, spacing), { number, slot });
			}
		}
	}
	for (std::size_t i = 0; i < now.size() && count > 0; i++) {
		for (int slot = 0; slot < now[i].size(); slot++) {
			if (const PlantPlace *from = named.find(name_of(now[i], slot, spacing))) {
				kept.push_back({ *from, { static_cast<int>(i), slot } });
			}
		}
	}
	return kept;
}

} // namespace undergrowth

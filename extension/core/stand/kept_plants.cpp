#include "stand/kept_plants.hpp"

#include "base/random.hpp"

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <limits>
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

/// True if the plants are the same as before, as after most changes. Then ids need no comparison.
bool are_the_same(const FilledBlocks &before, const std::vector<PlantBlock> &now, double spacing) {
	return std::equal(now.begin(), now.end(), before.blocks.begin(), before.blocks.end(),
			[spacing](const PlantBlock &block, const std::pair<int, PlantBlock> &was) {
				return was.second.spacing == spacing && was.second.gone == 0 && block.plants.x == was.second.plants.x &&
						block.plants.z == was.second.plants.z;
			});
}

/// Result for equal lists.
std::vector<KeptPlant> keep_all(const FilledBlocks &blocks) {
	std::vector<KeptPlant> kept;
	for (std::size_t i = 0; i < blocks.blocks.size(); i++) {
		const auto &[number, block] = blocks.blocks[i];
		for (int slot = 0; slot < block.size(); slot++) {
			kept.push_back({ { number, slot }, { static_cast<int>(i), slot } });
		}
	}
	return kept;
}

/// A grid around the cells of some plants. Its numbers of columns and rows are powers of two.
struct CellGrid {
	int first_column = 0;
	int first_row = 0;
	int column_bits = 0;
	int row_bits = 0;

	/// Index row by row, or -1 outside.
	int64_t place_of(PlantId name) const {
		int column = 0;
		int row = 0;
		filled_plant_cell(name, column, row);
		const uint32_t x = static_cast<uint32_t>(column) - static_cast<uint32_t>(first_column);
		const uint32_t y = static_cast<uint32_t>(row) - static_cast<uint32_t>(first_row);
		const bool is_inside = x >> column_bits == 0 && y >> row_bits == 0;
		return is_inside ? (static_cast<int64_t>(y) << column_bits) + x : -1;
	}
};

int bits_for(int64_t count) {
	int bits = 0;
	while ((int64_t(1) << bits) < count) {
		bits++;
	}
	return bits;
}

/// Grid around all cells of a spacing.
CellGrid grid_around(const FilledBlocks &filled, double spacing) {
	glm::ivec2 low(std::numeric_limits<int>::max());
	glm::ivec2 high(std::numeric_limits<int>::min());
	for (const auto &[number, block] : filled.blocks) {
		for (const glm::vec3 &corner : { block.low, block.high }) {
			glm::ivec2 cell;
			filled_plant_cell(filled_plant_id(corner.x, corner.z, spacing), cell.x, cell.y);
			low = block.spacing == spacing ? glm::min(low, cell) : low;
			high = block.spacing == spacing ? glm::max(high, cell) : high;
		}
	}
	low.x--; // Rows are shifted by half a cell.
	high.x++;
	return { low.x, low.y, bits_for(int64_t(high.x) - low.x + 1), bits_for(int64_t(high.y) - low.y + 1) };
}

/// Maps ids to plants: a hash table with open addressing, at most half full. If the cells fill a rectangle it is a grid
/// without stored ids, in which neighbours are adjacent.
class PlacesByName {
public:
	PlacesByName(const CellGrid &around, std::size_t count) : grid(around) {
		const int bits = bits_for(2 * static_cast<int64_t>(count));
		is_grid = grid.column_bits + grid.row_bits <= bits;
		last = (std::size_t(1) << bits) - 1;
		places.resize(last + 1, { NOWHERE, 0 });
		names.resize(is_grid ? 0 : last + 1, NO_PLANT);
	}

	void add(PlantId name, const PlantPlace &place) {
		const std::size_t slot = slot_of(name);
		places[slot] = place;
		if (!is_grid) {
			names[slot] = name;
		}
	}

	const PlantPlace *find(PlantId name) const {
		if (is_grid && grid.place_of(name) < 0) {
			return nullptr;
		}
		const std::size_t slot = slot_of(name);
		return places[slot].block == NOWHERE ? nullptr : &places[slot];
	}

private:
	static constexpr int NOWHERE = -1;
	CellGrid grid;
	bool is_grid = false;
	std::size_t last = 0; ///< Mask: all bits below a power of two.
	std::vector<PlantPlace> places;
	std::vector<PlantId> names; ///< Unused in a grid.

	/// Slot of an id, or the slot where it would be inserted; in a grid only for ids within it.
	std::size_t slot_of(PlantId name) const {
		if (is_grid) {
			return static_cast<std::size_t>(grid.place_of(name));
		}
		std::size_t slot = mix_bits(static_cast<uint64_t>(name)) & last;
		while (names[slot] != name && names[slot] != NO_PLANT) {
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
	if (are_the_same(before, now, spacing)) {
		return keep_all(before);
	}
	std::size_t count = 0;
	for (const auto &[number, block] : before.blocks) {
		count += block.spacing == spacing ? static_cast<std::size_t>(block.size()) : 0;
	}
	if (count == 0) {
		return {};
	}
	PlacesByName named(grid_around(before, spacing), count);
	for (const auto &[number, block] : before.blocks) {
		for (int slot = 0; block.spacing == spacing && slot < block.size(); slot++) {
			if (!block.is_gone(slot)) {
				named.add(name_of(block, slot, spacing), { number, slot });
			}
		}
	}
	std::vector<KeptPlant> kept;
	for (std::size_t i = 0; i < now.size(); i++) {
		for (int slot = 0; slot < now[i].size(); slot++) {
			if (const PlantPlace *from = named.find(name_of(now[i], slot, spacing))) {
				kept.push_back({ *from, { static_cast<int>(i), slot } });
			}
		}
	}
	return kept;
}

} // namespace undergrowth

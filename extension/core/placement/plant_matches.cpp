#include "placement/plant_matches.hpp"

#include "base/random.hpp"

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

namespace undergrowth {

namespace {

PlantId id_of(const PlantChunk &chunk, int slot, double spacing) {
	const glm::vec3 root = chunk.root(slot);
	return generated_plant_id(root.x, root.z, spacing);
}

GeneratedChunks chunks_of(const PlantStore &store, const std::vector<int> &numbers) {
	GeneratedChunks generated;
	generated.spacing = store.spacing();
	for (const int number : numbers) {
		const PlantChunk &chunk = store.chunk(number);
		if (!chunk.is_added && chunk.live_count() > 0) {
			generated.chunks.emplace_back(number, store.share(number));
		}
	}
	return generated;
}

/// True if the plants are the same as before, as after most changes. Then ids need no comparison.
bool are_the_same(const GeneratedChunks &before, const std::vector<PlantChunk> &now, double spacing) {
	return std::equal(now.begin(), now.end(), before.chunks.begin(), before.chunks.end(),
			[spacing](const PlantChunk &chunk, const std::pair<int, std::shared_ptr<const PlantChunk>> &was) {
				return was.second->spacing == spacing && was.second->gone == 0 &&
						chunk.plants.x == was.second->plants.x && chunk.plants.z == was.second->plants.z;
			});
}

/// Result for equal lists.
std::vector<PlantMatch> keep_all(const GeneratedChunks &chunks) {
	std::vector<PlantMatch> matches;
	for (std::size_t i = 0; i < chunks.chunks.size(); i++) {
		const auto &[number, chunk] = chunks.chunks[i];
		for (int slot = 0; slot < chunk->size(); slot++) {
			matches.push_back({ { number, slot }, { static_cast<int>(i), slot } });
		}
	}
	return matches;
}

/// A grid around the cells of some plants. Its numbers of columns and rows are powers of two.
struct CellGrid {
	int first_column = 0;
	int first_row = 0;
	int column_bits = 0;
	int row_bits = 0;

	/// Index row by row, or -1 outside.
	int64_t place_of(PlantId id) const {
		int column = 0;
		int row = 0;
		generated_plant_cell(id, column, row);
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
CellGrid grid_around(const GeneratedChunks &generated, double spacing) {
	glm::ivec2 low(std::numeric_limits<int>::max());
	glm::ivec2 high(std::numeric_limits<int>::min());
	for (const auto &[number, chunk] : generated.chunks) {
		for (const glm::vec3 &corner : { chunk->low, chunk->high }) {
			glm::ivec2 cell;
			generated_plant_cell(generated_plant_id(corner.x, corner.z, spacing), cell.x, cell.y);
			low = chunk->spacing == spacing ? glm::min(low, cell) : low;
			high = chunk->spacing == spacing ? glm::max(high, cell) : high;
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
		ids.resize(is_grid ? 0 : last + 1, NO_PLANT);
	}

	void add(PlantId id, const PlantRef &place) {
		const std::size_t slot = slot_of(id);
		places[slot] = place;
		if (!is_grid) {
			ids[slot] = id;
		}
	}

	const PlantRef *find(PlantId id) const {
		if (is_grid && grid.place_of(id) < 0) {
			return nullptr;
		}
		const std::size_t slot = slot_of(id);
		return places[slot].chunk == NOWHERE ? nullptr : &places[slot];
	}

private:
	static constexpr int NOWHERE = -1;
	CellGrid grid;
	bool is_grid = false;
	std::size_t last = 0; ///< Mask: all bits below a power of two.
	std::vector<PlantRef> places;
	std::vector<PlantId> ids; ///< Unused in a grid.

	/// Slot of an id, or the slot where it would be inserted; in a grid only for ids within it.
	std::size_t slot_of(PlantId id) const {
		if (is_grid) {
			return static_cast<std::size_t>(grid.place_of(id));
		}
		std::size_t slot = mix_bits(static_cast<uint64_t>(id)) & last;
		while (ids[slot] != id && ids[slot] != NO_PLANT) {
			slot = (slot + 1) & last;
		}
		return slot;
	}
};

} // namespace

GeneratedChunks share_generated(const PlantStore &store) {
	std::vector<int> numbers(static_cast<std::size_t>(store.chunk_count()));
	std::iota(numbers.begin(), numbers.end(), 0);
	return chunks_of(store, numbers);
}

GeneratedChunks share_generated_in(const PlantStore &store, const TileKey &tile) {
	return chunks_of(store, store.chunks_of(tile));
}

FieldPlants gather_plants(const GeneratedChunks &generated, const std::vector<int> &species_numbers) {
	FieldPlants plants;
	for (const auto &[number, chunk] : generated.chunks) {
		const int species = species_numbers[static_cast<std::size_t>(chunk->species)];
		for (int slot = 0; slot < chunk->size() && species >= 0; slot++) {
			if (!chunk->is_gone(slot)) {
				PlacedPlant plant = chunk->plants.plant(slot);
				plant.species = species;
				plants.add(plant);
			}
		}
	}
	return plants;
}

std::vector<PlantMatch> match_plants(
		const GeneratedChunks &before, const std::vector<PlantChunk> &now, double spacing) {
	if (are_the_same(before, now, spacing)) {
		return keep_all(before);
	}
	std::size_t count = 0;
	for (const auto &[number, chunk] : before.chunks) {
		count += chunk->spacing == spacing ? static_cast<std::size_t>(chunk->size()) : 0;
	}
	if (count == 0) {
		return {};
	}
	PlacesByName by_id(grid_around(before, spacing), count);
	for (const auto &[number, chunk] : before.chunks) {
		for (int slot = 0; chunk->spacing == spacing && slot < chunk->size(); slot++) {
			if (!chunk->is_gone(slot)) {
				by_id.add(id_of(*chunk, slot, spacing), { number, slot });
			}
		}
	}
	std::vector<PlantMatch> matches;
	for (std::size_t i = 0; i < now.size(); i++) {
		for (int slot = 0; slot < now[i].size(); slot++) {
			if (const PlantRef *from = by_id.find(id_of(now[i], slot, spacing))) {
				matches.push_back({ *from, { static_cast<int>(i), slot } });
			}
		}
	}
	return matches;
}

} // namespace undergrowth

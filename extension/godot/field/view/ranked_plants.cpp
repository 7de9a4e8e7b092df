#include "field/view/ranked_plants.hpp"

#include "base/counting_sort.hpp"
#include "placement/lod_density.hpp"

#include <cmath>
#include <numeric>

using namespace godot;

namespace undergrowth {

// Compatibility stores custom data in half floats, which are exact for integers from -2048 to 2048.
static constexpr int HALVES_COUNT_FROM = -2048;
// For plants of parts only the parts are drawn wider.
static constexpr float PARTS_WIDENING = 1.25f;
// Ranks are sorted by the lower half of their bits, then by the upper half.
static constexpr int HALF_RANKS = 1 << (RANK_BITS / 2);

static int rank_of(const PlantChunk &chunk, int slot) {
	return int(plant_rank(chunk.id(slot)) * float(RANK_COUNT));
}

static DrawnPlant drawn_plant(const SpeciesStyle &style, const DrawnChunk &drawn, const PlacedPlant &plant, int slot) {
	const FieldPlants &plants = drawn.chunk->plants;
	const size_t at = size_t(slot);
	DrawnPlant made;
	made.root = plant.root;
	made.scale = plant.scale;
	made.height = style.height_of(plant);
	made.rank_code = uint32_t(rank_of(*drawn.chunk, slot));
	made.variant = uint32_t(size_t(plant.variant) % style.variants.size());
	made.turn = plants.turn[at];
	made.texel = int16_t(drawn.texels.first + slot + HALVES_COUNT_FROM);
	made.layer = int16_t(drawn.texels.layer + HALVES_COUNT_FROM);
	made.lightness = plants.lightness[at];
	made.warmth = plants.warmth[at];
	return made;
}

RankedPlants rank_plants(const FieldRenderSetup &setup, const std::vector<DrawnChunk> &chunks) {
	size_t count = 0;
	for (const DrawnChunk &drawn : chunks) {
		count += size_t(drawn.chunk->size());
	}
	RankedPlants ranked;
	ranked.plants.reserve(count);
	ranked.reaches.reserve(count);
	for (const DrawnChunk &drawn : chunks) {
		const SpeciesStyle &style = setup.styles[size_t(drawn.chunk->species)];
		ranked.begins.push_back(int(ranked.plants.size()));
		for (int slot = 0; slot < drawn.chunk->size(); slot++) {
			if (!drawn.chunk->is_gone(slot)) {
				const PlacedPlant plant = drawn.chunk->plants.plant(slot);
				ranked.plants.push_back(drawn_plant(style, drawn, plant, slot));
				ranked.reaches.push_back(style.reach_of(plant, style.has_parts() ? PARTS_WIDENING : MAX_WIDENING));
			}
		}
	}
	ranked.begins.push_back(int(ranked.plants.size()));
	ranked.by_rank.resize(ranked.plants.size());
	std::iota(ranked.by_rank.begin(), ranked.by_rank.end(), 0);
	const auto rank = [&](int i) { return int(ranked.plants[size_t(i)].rank_code); };
	ranked.by_rank = counting_sort(ranked.by_rank, HALF_RANKS, [&](int i) { return rank(i) % HALF_RANKS; });
	ranked.by_rank = counting_sort(ranked.by_rank, HALF_RANKS, [&](int i) { return rank(i) / HALF_RANKS; });
	return ranked;
}

} // namespace undergrowth

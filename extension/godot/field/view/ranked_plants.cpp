#include "field/view/ranked_plants.hpp"

#include "base/counting_sort.hpp"
#include "field/view/plant_transforms.hpp"
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

static DrawnPlant drawn_plant(const FieldRenderSetup &setup, const DrawnChunk &drawn, int slot) {
	const SpeciesStyle &style = setup.styles[size_t(drawn.chunk->species)];
	const PlacedPlant plant = drawn.chunk->plants.plant(slot);
	const Basis axes = drawn_transform(plant).basis;
	DrawnPlant made;
	made.root = plant.root;
	made.scale = axes.rows[1].y;
	made.cosine = axes.rows[0].x;
	made.sine = axes.rows[0].z;
	made.texel = float(drawn.texels.first + slot + HALVES_COUNT_FROM);
	made.layer = float(drawn.texels.layer + HALVES_COUNT_FROM);
	made.height = style.height_of(plant);
	made.reach = style.reach_of(plant, style.has_parts() ? PARTS_WIDENING : MAX_WIDENING);
	made.variant = int(size_t(plant.variant) % style.variants.size());
	made.lightness = plant.lightness;
	made.warmth = plant.warmth;
	return made;
}

RankedPlants rank_plants(const FieldRenderSetup &setup, const std::vector<DrawnChunk> &chunks) {
	size_t count = 0;
	for (const DrawnChunk &drawn : chunks) {
		count += size_t(drawn.chunk->size());
	}
	RankedPlants ranked;
	ranked.plants.reserve(count);
	std::vector<int> ranks;
	ranks.reserve(count);
	for (const DrawnChunk &drawn : chunks) {
		ranked.begins.push_back(int(ranks.size()));
		for (int slot = 0; slot < drawn.chunk->size(); slot++) {
			if (!drawn.chunk->is_gone(slot)) {
				ranks.push_back(rank_of(*drawn.chunk, slot));
				ranked.plants.push_back(drawn_plant(setup, drawn, slot));
				DrawnPlant &plant = ranked.plants.back();
				plant.rank = float(ranks.back()) / float(RANK_COUNT);
				plant.step = int(std::ceil(plant.rank * RANK_STEPS));
			}
		}
	}
	ranked.begins.push_back(int(ranks.size()));
	ranked.by_rank.resize(ranks.size());
	std::iota(ranked.by_rank.begin(), ranked.by_rank.end(), 0);
	ranked.by_rank = counting_sort(ranked.by_rank, HALF_RANKS, [&](int i) { return ranks[size_t(i)] % HALF_RANKS; });
	ranked.by_rank = counting_sort(ranked.by_rank, HALF_RANKS, [&](int i) { return ranks[size_t(i)] / HALF_RANKS; });
	return ranked;
}

} // namespace undergrowth

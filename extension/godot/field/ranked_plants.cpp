#include "field/ranked_plants.hpp"

#include "base/counting_sort.hpp"
#include "field/plant_transforms.hpp"
#include "stand/thinning.hpp"

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

static int rank_of(const PlantBlock &block, int slot) {
	const glm::vec3 root = block.root(slot);
	const PlantId id = block.is_added ? block.ids[size_t(slot)] : filled_plant_id(root.x, root.z, block.spacing);
	return int(plant_rank(id) * float(RANK_COUNT));
}

static DrawnPlant drawn_plant(const FieldStyle &style, const DrawnBlock &drawn, int slot) {
	const FieldLook &look = style.looks[size_t(drawn.block->species)];
	const PlacedPlant plant = drawn.block->plants.plant(slot);
	const Basis axes = drawn_transform(plant).basis;
	DrawnPlant made;
	made.root = plant.root;
	made.scale = axes.rows[1].y;
	made.cosine = axes.rows[0].x;
	made.sine = axes.rows[0].z;
	made.texel = float(drawn.texels.first + slot + HALVES_COUNT_FROM);
	made.layer = float(drawn.texels.layer + HALVES_COUNT_FROM);
	made.height = look.height_of(plant);
	made.reach = look.reach_of(plant, look.has_parts() ? PARTS_WIDENING : MOST_WIDENING);
	made.variant = int(size_t(plant.variant) % look.variants.size());
	return made;
}

RankedPlants rank_plants(const FieldStyle &style, const std::vector<DrawnBlock> &blocks) {
	size_t count = 0;
	for (const DrawnBlock &drawn : blocks) {
		count += size_t(drawn.block->size());
	}
	RankedPlants ranked;
	ranked.plants.reserve(count);
	std::vector<int> ranks;
	ranks.reserve(count);
	for (const DrawnBlock &drawn : blocks) {
		ranked.begins.push_back(int(ranks.size()));
		for (int slot = 0; slot < drawn.block->size(); slot++) {
			if (!drawn.block->is_gone(slot)) {
				ranks.push_back(rank_of(*drawn.block, slot));
				ranked.plants.push_back(drawn_plant(style, drawn, slot));
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

#include "field/ranked_plants.hpp"

#include "base/counting_sort.hpp"
#include "field/plant_transforms.hpp"
#include "stand/thinning.hpp"

#include <numeric>
#include <utility>

using namespace godot;

namespace undergrowth {

// Compatibility keeps custom data in half floats, which count exactly from -2048 to 2048.
static constexpr int HALVES_COUNT_FROM = -2048;
// Of plants of parts only the parts are drawn wider, not the whole.
static constexpr float PARTS_WIDENING = 1.25f;
static constexpr int HALF_RANKS =
		1 << (RANK_BITS / 2); // Ranks are sorted by one half of their bits, then by the other.

static int rank_of(const PlantBlock &block, int slot) {
	const glm::vec3 root = block.root(slot);
	const PlantId id = block.is_added ? block.ids[size_t(slot)] : filled_plant_id(root.x, root.z, block.spacing);
	return int(plant_rank(id) * float(RANK_COUNT));
}

static RankedPlant ranked_plant(const FieldStyle &style, const DrawnBlock &drawn, int slot) {
	const FieldLook &look = style.looks[size_t(drawn.block->species)];
	const PlacedPlant plant = drawn.block->plants.plant(slot);
	RankedPlant ranked;
	ranked.transform = drawn_transform(plant);
	ranked.height = look.height_of(plant);
	ranked.reach = look.reach_of(plant, look.has_parts() ? PARTS_WIDENING : MOST_WIDENING);
	ranked.texel = float(drawn.texels.first + slot + HALVES_COUNT_FROM);
	ranked.layer = float(drawn.texels.layer + HALVES_COUNT_FROM);
	ranked.variant = int(size_t(plant.variant) % look.variants.size());
	return ranked;
}

std::vector<RankedPlant> rank_plants(const FieldStyle &style, const std::vector<DrawnBlock> &blocks) {
	std::vector<int> ranks;
	std::vector<std::pair<int, int>> places; // Block and slot.
	for (size_t i = 0; i < blocks.size(); i++) {
		const PlantBlock &block = *blocks[i].block;
		for (int slot = 0; slot < block.size(); slot++) {
			if (!block.is_gone(slot)) {
				ranks.push_back(rank_of(block, slot));
				places.push_back({ int(i), slot });
			}
		}
	}
	std::vector<int> order(ranks.size());
	std::iota(order.begin(), order.end(), 0);
	order = counting_sort(order, HALF_RANKS, [&](int i) { return ranks[size_t(i)] % HALF_RANKS; });
	order = counting_sort(order, HALF_RANKS, [&](int i) { return ranks[size_t(i)] / HALF_RANKS; });
	std::vector<RankedPlant> plants;
	plants.reserve(order.size());
	for (const int i : order) {
		const auto [block, slot] = places[size_t(i)];
		plants.push_back(ranked_plant(style, blocks[size_t(block)], slot));
		plants.back().block = block;
		plants.back().rank = float(ranks[size_t(i)]) / float(RANK_COUNT);
	}
	return plants;
}

} // namespace undergrowth

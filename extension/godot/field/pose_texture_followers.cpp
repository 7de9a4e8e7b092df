// What a PoseTexture says of plants that follow prototypes, and of those prototypes.

#include "field/pose_texture.hpp"

#include <array>

using namespace godot;

namespace undergrowth {

static constexpr int PAIRS_PER_LAYER = PoseTexture::PAIRS_PER_LAYER;
static constexpr int HISTORY_LAYERS = Prototypes::SLOTS * Prototypes::MOST / PAIRS_PER_LAYER;
static constexpr int SPECIES_LAYERS = HISTORY_LAYERS + 1; // And one of loose plants.

static_assert(LoosePlants::MOST <= PAIRS_PER_LAYER, "loose plants of a species have one layer");
static_assert(Prototypes::MOST == PoseTexture::SIDE, "a row of a layer is a slot");

void PoseTexture::give_history(int species_count) {
	while (follows_prototypes && int(histories.size()) < species_count) {
		histories.push_back(int(layers.size()));
		for (int i = 0; i < SPECIES_LAYERS; i++) {
			add_layer(false);
		}
	}
}

int PoseTexture::history_layer(int species) const {
	return size_t(species) < histories.size() ? histories[size_t(species)] : -1;
}

static const std::array<uint32_t, Prototypes::SLOTS> &small_halves() {
	static const std::array<uint32_t, Prototypes::SLOTS> halves = [] {
		std::array<uint32_t, Prototypes::SLOTS> made = {};
		for (size_t i = 0; i < made.size(); i++) {
			made[i] = to_half(float(i));
		}
		return made;
	}();
	return halves;
}

// A texel for each plant: its prototype and own delay, and one more than the column and the row of its place among the
// loose plants, or 0.
void PoseTexture::write_followers(const FieldSimulation &simulation, int page) {
	const std::array<uint32_t, Prototypes::SLOTS> &halves = small_halves();
	uint32_t *to = reinterpret_cast<uint32_t *>(bytes_of(pages[size_t(page)].rows));
	for (int i = 0; i < simulation.page(page).size(); i++) {
		const Follower &follower = simulation.follower(page, i);
		const uint32_t number = follower.loose > 0 ? follower.loose - 1u : 0u;
		const uint32_t column = follower.loose > 0 ? number % SIDE + 1u : 0u;
		to[2 * i] = halves[follower.prototype] | halves[follower.own_delay] << 16;
		to[2 * i + 1] = halves[column] | halves[number / SIDE] << 16;
	}
}

void PoseTexture::write_history(const FieldSimulation &simulation, bool all) {
	for (int species = 0; follows_prototypes && species < simulation.species_count(); species++) {
		const Prototypes &models = *simulation.prototypes(species);
		const int first = histories[size_t(species)];
		for (int layer = 0; all && layer < HISTORY_LAYERS; layer++) {
			write_layer(first + layer, models.history() + size_t(layer) * 2 * PAIRS_PER_LAYER, PAIRS_PER_LAYER, 0);
		}
		const int slot = models.newest_slot();
		write_layer(
				first + slot / SIDE, models.history() + size_t(slot) * 2 * Prototypes::MOST, SIDE, slot % SIDE * SIDE);
		const MotionPage &loose = simulation.loose_plants(species)->page();
		if (loose.size() > 0) {
			write_layer(first + HISTORY_LAYERS, loose.bends(), loose.size(), 0);
		}
	}
}

} // namespace undergrowth

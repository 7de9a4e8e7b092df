// Data of instances of prototypes in a PoseTexture, and of the prototypes.

#include "field/motion/pose_texture.hpp"

#include <algorithm>
#include <array>
#include <tuple>

using namespace godot;

namespace undergrowth {

static constexpr int PAIRS_PER_LAYER = PoseTexture::PAIRS_PER_LAYER;
static constexpr int HISTORY_LAYERS = Prototypes::SLOTS * Prototypes::MAX_COUNT / PAIRS_PER_LAYER;
static constexpr int SPECIES_LAYERS = HISTORY_LAYERS + 1; // And one for detached plants.

static_assert(DetachedFollowers::MAX_COUNT <= PAIRS_PER_LAYER, "detached plants of a species have one layer");
static_assert(Prototypes::MAX_COUNT == PoseTexture::SIDE, "a row of a layer is a slot");

void PoseTexture::give_history(const FieldSimulation &simulation) {
	const int species_count = follows_prototypes ? simulation.species_count() : 0;
	histories.resize(size_t(species_count), History{ -1, -1 });
	for (int species = 0; species < species_count; species++) {
		for (int mode = 0; mode < simulation.prototypes(species)->modes(); mode++) {
			int &first = histories[size_t(species)][size_t(mode)];
			if (first >= 0) {
				continue;
			}
			first = take_layers(SPECIES_LAYERS);
		}
	}
}

int PoseTexture::count_spare_layers() const {
	const auto is_used = [](uint64_t rows) { return rows != ALL_ROWS; };
	return int(std::find_if(free_rows.rbegin(), free_rows.rend(), is_used) - free_rows.rbegin());
}

// Takes spare layers first, so that the textures need not grow for each species.
int PoseTexture::take_layers(int count) {
	const int first = int(layers.size()) - count_spare_layers();
	for (int layer = first; layer < first + count; layer++) {
		if (layer == int(layers.size())) {
			add_layer(false);
		}
		free_rows[size_t(layer)] = 0;
	}
	return first;
}

int PoseTexture::history_layer(int species, int mode) const {
	return size_t(species) < histories.size() ? histories[size_t(species)][size_t(mode)] : -1;
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

// Writes a texel for each plant: its prototype and own delay, then its column plus 1 (0: not detached) and its row
// among the detached plants.
void PoseTexture::write_followers(const FieldSimulation &simulation, int page) {
	const std::array<uint32_t, Prototypes::SLOTS> &halves = small_halves();
	uint32_t *to = reinterpret_cast<uint32_t *>(bytes_of(pages[size_t(page)].rows));
	for (int i = 0; i < simulation.page(page).size(); i++) {
		const Follower &follower = simulation.follower(page, i);
		const uint32_t number = follower.detached > 0 ? follower.detached - 1u : 0u;
		const uint32_t column = follower.detached > 0 ? number % SIDE + 1u : 0u;
		to[2 * i] = halves[follower.prototype] | halves[follower.own_delay] << 16;
		to[2 * i + 1] = halves[column] | halves[number / SIDE] << 16;
	}
}

void PoseTexture::write_models(const Prototypes &models, int mode, int first, bool all) {
	const Bend *history = models.history(mode);
	for (int layer = 0; all && layer < HISTORY_LAYERS; layer++) {
		write_layer(first + layer, history + size_t(layer) * 2 * PAIRS_PER_LAYER, PAIRS_PER_LAYER, 0);
	}
	const int slot = models.newest_slot();
	write_layer(first + slot / SIDE, history + size_t(slot) * 2 * Prototypes::MAX_COUNT, SIDE, slot % SIDE * SIDE);
}

bool PoseTexture::has_room_for_species() const {
	static constexpr size_t MAX_MODES = std::tuple_size_v<History>;
	const size_t used = layers.size() - size_t(count_spare_layers());
	return !follows_prototypes || used + MAX_MODES * SPECIES_LAYERS + SPARE_LAYERS <= size_t(MAX_LAYERS);
}

void PoseTexture::write_history(const FieldSimulation &simulation, bool all) {
	for (int species = 0; follows_prototypes && species < simulation.species_count(); species++) {
		write_species(simulation, species, all);
	}
}

void PoseTexture::write_history_of(const FieldSimulation &simulation, int species) {
	if (follows_prototypes) {
		write_species(simulation, species, true);
	}
}

void PoseTexture::write_species(const FieldSimulation &simulation, int species, bool all) {
	const Prototypes &models = *simulation.prototypes(species);
	const MotionPage &detached = simulation.detached_followers(species)->page();
	for (int mode = 0; mode < models.modes(); mode++) {
		const int first = history_layer(species, mode);
		write_models(models, mode, first, all);
		if (detached.size() > 0) {
			const Bend *bends = mode == 0 ? detached.bends() : detached.second_bends();
			write_layer(first + HISTORY_LAYERS, bends, detached.size(), 0);
		}
	}
}

} // namespace undergrowth

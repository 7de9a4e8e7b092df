#include "field/field_bends.hpp"

#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>
#include <array>
#include <cstring>

using namespace godot;

namespace undergrowth {

static constexpr int SIDE = 64;
static constexpr Bend HIDDEN = 0x7bffu; // s.x is the largest half, 65,504: no bend has it.
static constexpr int SPARE_PAGES = 16;
static constexpr int PAIRS_PER_LAYER = SIDE * SIDE;
static constexpr int HISTORY_LAYERS = Prototypes::SLOTS * Prototypes::MOST / PAIRS_PER_LAYER;
static constexpr int SPECIES_LAYERS = HISTORY_LAYERS + 1; // And one of loose plants.
static_assert(LoosePlants::MOST <= PAIRS_PER_LAYER, "loose plants of a species have one layer");
static_assert(MotionPage::PAGE_PLANTS == PAIRS_PER_LAYER && Prototypes::MOST == SIDE, "a row of a layer is a slot");

FieldBends::~FieldBends() {
	RenderingServer *server = RenderingServer::get_singleton();
	for (const RID &one : { texture, blend_texture }) {
		if (server && one.is_valid()) {
			server->free_rid(one);
		}
	}
}

void FieldBends::make_images(const FieldSimulation &simulation) {
	follows = simulation.settings().prototypes > 0;
	page_layers = simulation.page_count() + SPARE_PAGES;
	const int count = page_layers + (follows ? SPECIES_LAYERS * simulation.species_count() : 0);
	layers.clear();
	for (int i = 0; i < std::max(count, 1); i++) {
		layers.push_back(Image::create_empty(SIDE, SIDE, false, Image::FORMAT_RGBAH));
	}
	is_fresh.assign(layers.size(), 0);
	blends = Image::create_empty(int(layers.size()), 1, false, Image::FORMAT_RF);
	shares.assign(layers.size(), 0.0f);
	loose_versions.assign(size_t(page_layers), 0);
	for (int page = 0; page < simulation.page_count(); page++) {
		write_page(simulation, page);
	}
	for (int species = 0; follows && species < simulation.species_count(); species++) {
		const Bend *from = simulation.prototypes(species)->history();
		for (int i = 0; i < HISTORY_LAYERS; i++) {
			write_layer(history_layer(species) + i, from + 2 * size_t(i) * PAIRS_PER_LAYER, PAIRS_PER_LAYER, 0);
		}
	}
}

void FieldBends::make_textures() {
	TypedArray<Image> images;
	for (const Ref<Image> &layer : layers) {
		images.push_back(layer);
	}
	RenderingServer *server = RenderingServer::get_singleton();
	texture = server->texture_2d_layered_create(images, RenderingServer::TEXTURE_LAYERED_2D_ARRAY);
	blend_texture = server->texture_2d_create(blends);
	std::fill(is_fresh.begin(), is_fresh.end(), uint8_t(0));
}

bool FieldBends::has_room(const FieldSimulation &simulation) const {
	const int wanted = page_layers + (follows ? SPECIES_LAYERS * simulation.species_count() : 0);
	return follows == (simulation.settings().prototypes > 0) && simulation.page_count() <= page_layers &&
			wanted <= int(layers.size());
}

int FieldBends::history_layer(int species) const {
	return page_layers + SPECIES_LAYERS * species;
}

void FieldBends::write_layer(int layer, const Bend *from, int pairs, int first) {
	uint8_t *to = layers[size_t(layer)]->ptrw() + size_t(first) * 2 * sizeof(Bend);
	std::memcpy(to, from, size_t(pairs) * 2 * sizeof(Bend));
	is_fresh[size_t(layer)] = 1;
}

void FieldBends::write_page(const FieldSimulation &simulation, int page) {
	if (follows) {
		write_followers(simulation, page);
	} else {
		write_layer(page, simulation.page(page).bends(), simulation.page(page).size(), 0);
		write_hidden(page);
	}
}

void FieldBends::write_hidden(int page) {
	const Bend pair[2] = { HIDDEN, HIDDEN };
	for (size_t i = 0; size_t(page) < hidden.size() && i < hidden[size_t(page)].size(); i++) {
		const size_t index = size_t(hidden[size_t(page)][i]);
		std::memcpy(layers[size_t(page)]->ptrw() + index * sizeof(pair), pair, sizeof(pair));
	}
}

void FieldBends::hide(int page, int index) {
	hidden.resize(std::max(hidden.size(), size_t(page) + 1));
	hidden[size_t(page)].push_back(index);
}

std::vector<int> FieldBends::hidden_pages() const {
	std::vector<int> pages;
	for (size_t page = 0; page < hidden.size(); page++) {
		if (!hidden[page].empty()) {
			pages.push_back(int(page));
		}
	}
	return pages;
}

void FieldBends::show_all() {
	hidden.clear();
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
void FieldBends::write_followers(const FieldSimulation &simulation, int page) {
	const std::array<uint32_t, Prototypes::SLOTS> &halves = small_halves();
	uint32_t *to = reinterpret_cast<uint32_t *>(layers[size_t(page)]->ptrw());
	for (int i = 0; i < simulation.page(page).size(); i++) {
		const Follower &follower = simulation.follower(page, i);
		const uint32_t number = follower.loose > 0 ? follower.loose - 1u : 0u;
		const uint32_t column = follower.loose > 0 ? number % SIDE + 1u : 0u;
		to[2 * i] = halves[follower.prototype] | halves[follower.own_delay] << 16;
		to[2 * i + 1] = halves[column] | halves[number / SIDE] << 16;
	}
	is_fresh[size_t(page)] = 1;
	loose_versions[size_t(page)] = simulation.loose_version(page);
	write_hidden(page);
}

void FieldBends::write_history(const FieldSimulation &simulation) {
	for (int species = 0; species < simulation.species_count(); species++) {
		const Prototypes &models = *simulation.prototypes(species);
		const int slot = models.newest_slot();
		const Bend *from = models.history() + 2 * size_t(slot) * Prototypes::MOST;
		write_layer(history_layer(species) + slot / SIDE, from, SIDE, slot % SIDE * SIDE);
		const MotionPage &loose = simulation.loose_plants(species)->page();
		if (loose.size() > 0) {
			write_layer(history_layer(species) + HISTORY_LAYERS, loose.bends(), loose.size(), 0);
		}
	}
	for (int page = 0; page < simulation.page_count(); page++) {
		if (simulation.loose_version(page) != loose_versions[size_t(page)]) {
			write_followers(simulation, page);
		}
	}
}

void FieldBends::upload(const FieldSimulation &simulation, float fraction) {
	RenderingServer *server = RenderingServer::get_singleton();
	for (size_t i = 0; i < layers.size(); i++) {
		if (is_fresh[i]) {
			server->texture_2d_update(texture, layers[i], int(i));
			is_fresh[i] = 0;
		}
	}
	if (follows) {
		return; // Followers' blend is one for all: a uniform.
	}
	bool has_changed = false;
	for (int page = 0; page < simulation.page_count(); page++) {
		const float share = simulation.alpha(page, fraction);
		has_changed = has_changed || share != shares[size_t(page)];
		shares[size_t(page)] = share;
	}
	if (has_changed) {
		std::memcpy(blends->ptrw(), shares.data(), shares.size() * sizeof(float));
		server->texture_2d_update(blend_texture, blends, 0);
	}
}

size_t FieldBends::bytes() const {
	return layers.size() * PAIRS_PER_LAYER * 2 * sizeof(Bend);
}

} // namespace undergrowth

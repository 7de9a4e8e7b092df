#include "field/motion/pose_texture.hpp"

#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <tuple>

using namespace godot;

namespace undergrowth {

static constexpr Bend HIDDEN = 0x7bffu; // s.x is the largest half, 65,504: no bend has it.
static constexpr int PAIRS_PER_LAYER = PoseTexture::PAIRS_PER_LAYER;
static constexpr int HISTORY_LAYERS = Prototypes::SLOTS * Prototypes::MAX_COUNT / PAIRS_PER_LAYER;
static constexpr int SPECIES_LAYERS = HISTORY_LAYERS + 1; // And one for detached plants.

static_assert(MotionPage::PAGE_PLANTS == PAIRS_PER_LAYER, "a page fits into a layer");
static_assert(DetachedFollowers::MAX_COUNT <= PAIRS_PER_LAYER, "detached plants of a species have one layer");
static_assert(Prototypes::MAX_COUNT == PoseTexture::SIDE, "a row of a layer is a slot");

PoseTexture::PoseTexture(bool follows) : follows_prototypes(follows) {}

PoseTexture::~PoseTexture() {
	free_textures();
}

void PoseTexture::free_textures() {
	RenderingServer *server = RenderingServer::get_singleton();
	for (RID *one : { &texture, &blend_texture, &beat_texture }) {
		if (server && one->is_valid()) {
			server->free_rid(*one);
		}
		*one = RID();
	}
}

int PoseTexture::add_layer(bool is_shared) {
	layers.push_back(Image::create_empty(SIDE, SIDE, false, Image::FORMAT_RGBAH));
	free_rows.push_back(is_shared ? ALL_ROWS : 0);
	is_dirty.push_back(1);
	return int(layers.size()) - 1;
}

// Returns the first position with `count` adjacent free rows. It searches the last layers first, because these have
// more room. Spare layers come after them.
PoseTexture::Rows PoseTexture::find_rows(int count) {
	static constexpr int SEARCHED = 16; // More would cost more than they save.
	const uint64_t wanted = count >= SIDE ? ALL_ROWS : (uint64_t(1) << count) - 1;
	const int spare = int(layers.size()) - count_spare_layers();
	for (int i = 0; i <= SEARCHED; i++) {
		const int layer = i < SEARCHED ? spare - 1 - i : spare;
		if (layer < 0 || layer >= int(layers.size())) {
			continue;
		}
		uint64_t begins = free_rows[size_t(layer)]; // Bits of rows at which `seen` free rows begin.
		for (int seen = 1; seen < count && begins != 0;) {
			const int more = std::min(seen, count - seen);
			begins &= begins >> more;
			seen += more;
		}
		for (int first = 0; begins != 0; first++, begins >>= 1) {
			if (begins & 1) {
				free_rows[size_t(layer)] &= ~(wanted << first);
				return { layer, first, count };
			}
		}
	}
	add_layer(true);
	return find_rows(count);
}

PoseTexels TexelRows::texels() const {
	return { layer, first * PoseTexture::SIDE };
}

void PoseTexture::release(const TexelRows &rows) {
	if (rows.layer < 0) {
		return;
	}
	const uint64_t taken = rows.count >= SIDE ? ALL_ROWS : (uint64_t(1) << rows.count) - 1;
	free_rows[size_t(rows.layer)] |= taken << rows.first;
}

void PoseTexture::give_rows(int page, int plants) {
	add_pages(page);
	Page &own = pages[size_t(page)];
	const int count = (plants + SIDE - 1) / SIDE;
	if (own.rows.layer >= 0 && own.rows.count >= count) {
		return;
	}
	if (own.rows.layer >= 0) {
		// A page that grows will grow again.
		release(own.rows);
		take_as_new(page, find_rows(std::min(std::max(count, 2 * own.rows.count), SIDE)));
	} else {
		take_as_new(page, find_rows(count));
	}
}

void PoseTexture::make_room(double row_count) {
	for (double rows = 0.0; rows < row_count && layers.size() + SPARE_LAYERS < size_t(MAX_LAYERS); rows += SIDE) {
		add_layer(true);
	}
}

// Up to this one.
void PoseTexture::add_pages(int page) {
	pages.resize(std::max(pages.size(), size_t(page) + 1));
	blends_sent.resize(pages.size());
}

void PoseTexture::take_as_new(int page, const Rows &rows) {
	pages[size_t(page)].rows = rows;
	pages[size_t(page)].rate_time = -1.0f;
	blends_sent[size_t(page)] = { rows.layer * SIDE + rows.first, rows.count, -1.0f };
	has_new_rows = true;
	forget_heights(rows);
}

void PoseTexture::give_reserved(int page, const TexelRows &rows) {
	add_pages(page);
	take_as_new(page, rows);
}

void PoseTexture::leave_rows(int page) {
	if (has_rows(page)) {
		Page &own = pages[size_t(page)];
		own.hidden.clear();
		for (int row = 0; row < own.rows.count * SIDE; row++) {
			own.hidden.push_back(uint16_t(row));
		}
		write_hidden(own);
		will_write(page);
		own = Page();
		blends_sent[size_t(page)] = {};
	}
}

void PoseTexture::take_rows(int page) {
	if (has_rows(page)) {
		release(pages[size_t(page)].rows);
		pages[size_t(page)] = Page();
		blends_sent[size_t(page)] = {};
	}
}

bool PoseTexture::is_too_large() const {
	return layers.size() + SPARE_LAYERS > size_t(MAX_LAYERS);
}

PoseTexels PoseTexture::texels(const PageRows &plants) const {
	const Rows &own = pages[size_t(plants.page)].rows;
	return { own.layer, own.first * SIDE + plants.first };
}

uint8_t *PoseTexture::bytes_of(const Rows &rows) {
	return layers[size_t(rows.layer)]->ptrw() + size_t(rows.first) * SIDE * TEXEL_BYTES;
}

void PoseTexture::write_page(const FieldSimulation &simulation, int page) {
	if (!has_rows(page)) {
		return;
	}
	will_write(page);
	if (follows_prototypes) {
		write_followers(simulation, page);
		write_hidden(pages[size_t(page)]);
	} else {
		write_bends(simulation, page);
	}
}

void PoseTexture::write_pages(const FieldSimulation &simulation) {
	for (int page = 0; page < int(pages.size()); page++) {
		write_page(simulation, page);
	}
}

void PoseTexture::will_write(int page) {
	const int layer = layer_of(page);
	is_dirty[size_t(layer)] = 1;
	if (beside(layer).seconds >= 0) {
		is_dirty[size_t(beside(layer).seconds)] = 1;
	}
}

void PoseTexture::write_bends(const FieldSimulation &simulation, int page) {
	const MotionPage &plants = simulation.page(page);
	const Page &own = pages[size_t(page)];
	std::memcpy(bytes_of(own.rows), plants.bends(), size_t(plants.size()) * TEXEL_BYTES);
	const int seconds = beside(own.rows.layer).seconds;
	if (plants.has_second_bends() && seconds >= 0) {
		const Rows rows = { seconds, own.rows.first, own.rows.count };
		std::memcpy(bytes_of(rows), plants.second_bends(), size_t(plants.size()) * TEXEL_BYTES);
	}
	write_hidden(own);
}

void PoseTexture::write_hidden(const Page &page) {
	const Bend pair[2] = { HIDDEN, HIDDEN };
	uint8_t *to = page.hidden.empty() ? nullptr : bytes_of(page.rows);
	for (const uint16_t row : page.hidden) {
		std::memcpy(to + size_t(row) * TEXEL_BYTES, pair, TEXEL_BYTES);
	}
}

void PoseTexture::hide(int page, int row) {
	Page &own = pages[size_t(page)];
	own.hidden.push_back(uint16_t(row));
	const Bend pair[2] = { HIDDEN, HIDDEN };
	std::memcpy(bytes_of(own.rows) + size_t(row) * TEXEL_BYTES, pair, TEXEL_BYTES);
	will_write(page);
}

void PoseTexture::show(int page, int row) {
	std::vector<uint16_t> &hidden = pages[size_t(page)].hidden;
	const auto found = std::find(hidden.begin(), hidden.end(), uint16_t(row));
	if (found != hidden.end()) {
		*found = hidden.back();
		hidden.pop_back();
	}
}

void PoseTexture::write_layer(int layer, const Bend *from, int pairs, int first) {
	std::memcpy(layers[size_t(layer)]->ptrw() + size_t(first) * TEXEL_BYTES, from, size_t(pairs) * TEXEL_BYTES);
	is_dirty[size_t(layer)] = 1;
}

bool PoseTexture::make_textures() {
	if (texture.is_valid() && textured_layers >= layers.size()) {
		return false;
	}
	// Textures that grew will grow again.
	const size_t spare = texture.is_valid() ? std::max(layers.size() / 8, size_t(SPARE_LAYERS)) : size_t(SPARE_LAYERS);
	for (size_t i = 0; i < spare && layers.size() < size_t(MAX_LAYERS); i++) {
		add_layer(true);
	}
	free_textures();
	TypedArray<Image> images;
	for (const Ref<Image> &layer : layers) {
		images.push_back(layer);
	}
	RenderingServer *server = RenderingServer::get_singleton();
	texture = server->texture_2d_layered_create(images, RenderingServer::TEXTURE_LAYERED_2D_ARRAY);
	blend_image = Image::create_empty(SIDE, int(layers.size()), false, Image::FORMAT_RF);
	shares.assign(layers.size() * SIDE, 0.0f);
	blend_texture = server->texture_2d_create(blend_image);
	beat_image = Image::create_empty(SIDE, int(layers.size()), false, Image::FORMAT_RGBAF);
	beats_sent.assign(BEAT_FLOATS * layers.size() * SIDE, 0.0f);
	beat_texture = server->texture_2d_create(beat_image);
	std::fill(is_dirty.begin(), is_dirty.end(), uint8_t(0));
	for (Page &page : pages) {
		page.rate_time = -1.0f;
	}
	for (BlendRows &rows : blends_sent) {
		rows.share = -1.0f;
	}
	has_new_rows = true;
	textured_layers = layers.size();
	return true;
}

void PoseTexture::upload(const FieldSimulation &simulation, float fraction) {
	upload_layers();
	// Followers have one interval and one blend for all: a uniform.
	if (has_new_rows || (!follows_prototypes && simulation.rates_version() != sent_rates)) {
		upload_beats(simulation);
	}
	if (!follows_prototypes) {
		upload_blends(simulation, fraction);
	}
}

void PoseTexture::upload_layers() {
	RenderingServer *server = RenderingServer::get_singleton();
	for (size_t layer = 0; layer < layers.size(); layer++) {
		if (is_dirty[layer]) {
			server->texture_2d_update(texture, layers[layer], int(layer));
			is_dirty[layer] = 0;
		}
	}
}

// Pages with a longer interval get another blend in each frame, so this reads only what it needs of each page.
void PoseTexture::upload_blends(const FieldSimulation &simulation, float fraction) {
	bool has_changed = false;
	for (size_t number = 0; number < blends_sent.size(); number++) {
		BlendRows &rows = blends_sent[number];
		if (rows.count == 0) {
			continue;
		}
		const float share = simulation.alpha(int(number), fraction);
		if (share != rows.share) {
			rows.share = share;
			std::fill_n(shares.data() + rows.first, rows.count, share);
			has_changed = true;
		}
	}
	if (has_changed) {
		std::memcpy(blend_image->ptrw(), shares.data(), shares.size() * sizeof(float));
		RenderingServer::get_singleton()->texture_2d_update(blend_texture, blend_image, 0);
	}
}

PoseTexture::Beside PoseTexture::beside(int layer) const {
	return size_t(layer) < besides.size() ? besides[size_t(layer)] : Beside();
}

// Prefers a free layer, which needs no larger texture.
int PoseTexture::find_layer() {
	const auto free = std::find(free_rows.begin(), free_rows.end(), ALL_ROWS);
	if (free == free_rows.end()) {
		return add_layer(false);
	}
	*free = 0;
	return int(free - free_rows.begin());
}

int PoseTexture::add_beside(int layer, int Beside::*which) {
	if (beside(layer).*which < 0 && layers.size() < size_t(MAX_LAYERS) - SPARE_LAYERS) {
		besides.resize(std::max(besides.size(), size_t(layer) + 1));
		const int made = find_layer();
		besides[size_t(layer)].*which = made;
		std::memset(layers[size_t(made)]->ptrw(), 0, PAIRS_PER_LAYER * TEXEL_BYTES);
		is_dirty[size_t(made)] = 1;
	}
	return beside(layer).*which;
}

void PoseTexture::write_beside(const FieldSimulation &simulation, int page) {
	if (!has_rows(page)) {
		return;
	}
	pages[size_t(page)].rate_time = -1.0f; // Sent again.
	has_new_rows = true;
	if (simulation.page(page).has_second_bends()) {
		give_seconds(simulation, page);
		write_page(simulation, page);
	}
	if (simulation.has_parts(page) || simulation.page(page).law() == Law::stem) {
		write_rests(simulation, page);
	}
}

void PoseTexture::give_seconds(const FieldSimulation &simulation, int page) {
	if (has_rows(page) && simulation.page(page).has_second_bends()) {
		add_beside(layer_of(page), &Beside::seconds);
	}
}

// Stores the lost fraction of the height, so that 0 means not mown.
void PoseTexture::set_height(int page, int row, float share) {
	const Rows &rows = pages[size_t(page)].rows;
	if (share == 1.0f && beside(rows.layer).heights < 0) {
		return;
	}
	if (beside(rows.layer).heights < 0) {
		for (Page &other : pages) { // All pages of the layer need the new layer number.
			other.rate_time = other.rows.layer == rows.layer ? -1.0f : other.rate_time;
		}
		has_new_rows = draws_heights = true;
	}
	const int layer = add_beside(rows.layer, &Beside::heights);
	if (layer >= 0) {
		const Bend pair[2] = { to_half(share - 1.0f), 0 };
		write_layer(layer, pair, 1, rows.first * SIDE + row);
	}
}

void PoseTexture::forget_heights(const Rows &rows) {
	const int layer = beside(rows.layer).heights;
	if (layer >= 0) {
		uint8_t *to = layers[size_t(layer)]->ptrw() + size_t(rows.first) * SIDE * TEXEL_BYTES;
		std::memset(to, 0, size_t(rows.count) * SIDE * TEXEL_BYTES);
		is_dirty[size_t(layer)] = 1;
	}
}

void PoseTexture::write_rests(const FieldSimulation &simulation, int page) {
	const Rows &rows = pages[size_t(page)].rows;
	std::vector<Bend> rests(2 * size_t(simulation.page(page).size()), 0);
	for (size_t i = 0; i < rests.size(); i += 2) {
		rests[i] = encode_bend(simulation.rest(page, int(i / 2)));
	}
	const bool are_upright = std::all_of(rests.begin(), rests.end(), [](Bend rest) { return rest == 0; });
	if (are_upright && beside(rows.layer).rests < 0) {
		return;
	}
	const int layer = add_beside(rows.layer, &Beside::rests);
	if (layer >= 0) {
		write_layer(layer, rests.data(), int(rests.size() / 2), rows.first * SIDE);
	}
}

void PoseTexture::upload_beats(const FieldSimulation &simulation) {
	bool has_changed = false;
	has_new_rows = false;
	sent_rates = simulation.rates_version();
	for (int number = 0; number < int(pages.size()); number++) {
		Page &page = pages[size_t(number)];
		const bool has_seconds = has_rows(number) && simulation.page(number).has_second_bends();
		const bool are_same = has_rows(number) && simulation.rate_time(number) == page.rate_time;
		if (!has_rows(number) || (are_same && has_seconds == page.has_seconds)) {
			continue;
		}
		page.rate_time = simulation.rate_time(number);
		page.has_seconds = has_seconds;
		const Beside layers_beside = beside(page.rows.layer);
		float *to = beats_sent.data() + BEAT_FLOATS * (size_t(page.rows.layer) * SIDE + size_t(page.rows.first));
		for (int row = 0; row < page.rows.count; row++) {
			*to++ = 1.0f / page.rate_time;
			*to++ = float(layers_beside.rests);
			*to++ = has_seconds ? float(layers_beside.seconds) : -1.0f;
			*to++ = float(layers_beside.heights);
		}
		has_changed = true;
	}
	if (has_changed) {
		std::memcpy(beat_image->ptrw(), beats_sent.data(), beats_sent.size() * sizeof(float));
		RenderingServer::get_singleton()->texture_2d_update(beat_texture, beat_image, 0);
	}
}

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

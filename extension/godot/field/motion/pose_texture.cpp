#include "field/motion/pose_texture.hpp"

#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>
#include <cstring>

using namespace godot;

namespace undergrowth {

static constexpr Bend HIDDEN = 0x7bffu; // s.x is the largest half, 65,504: no bend has it.
static constexpr int PAIRS_PER_LAYER = PoseTexture::PAIRS_PER_LAYER;

static_assert(MotionPage::PAGE_PLANTS == PAIRS_PER_LAYER, "a page fits into a layer");

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
	pages.resize(std::max(pages.size(), size_t(page) + 1));
	Page &own = pages[size_t(page)];
	const int count = (plants + SIDE - 1) / SIDE;
	if (own.rows.layer >= 0 && own.rows.count >= count) {
		return;
	}
	if (own.rows.layer >= 0) {
		// A page that grows will grow again.
		release(own.rows);
		take_as_new(own, find_rows(std::min(std::max(count, 2 * own.rows.count), SIDE)));
	} else {
		take_as_new(own, find_rows(count));
	}
}

void PoseTexture::make_room(double row_count) {
	for (double rows = 0.0; rows < row_count && layers.size() + SPARE_LAYERS < size_t(MAX_LAYERS); rows += SIDE) {
		add_layer(true);
	}
}

void PoseTexture::take_as_new(Page &page, const Rows &rows) {
	page.rows = rows;
	page.share = page.rate_time = -1.0f;
	has_new_rows = true;
	forget_heights(rows);
}

void PoseTexture::give_reserved(int page, const TexelRows &rows) {
	pages.resize(std::max(pages.size(), size_t(page) + 1));
	take_as_new(pages[size_t(page)], rows);
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
	}
}

void PoseTexture::take_rows(int page) {
	if (has_rows(page)) {
		release(pages[size_t(page)].rows);
		pages[size_t(page)] = Page();
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
		page.share = page.rate_time = -1.0f;
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

void PoseTexture::upload_blends(const FieldSimulation &simulation, float fraction) {
	bool has_changed = false;
	for (int number = 0; number < int(pages.size()); number++) {
		Page &page = pages[size_t(number)];
		const float share = has_rows(number) ? simulation.alpha(number, fraction) : page.share;
		if (share != page.share) {
			page.share = share;
			float *to = shares.data() + size_t(page.rows.layer) * SIDE + size_t(page.rows.first);
			std::fill(to, to + page.rows.count, share);
			has_changed = true;
		}
	}
	if (has_changed) {
		std::memcpy(blend_image->ptrw(), shares.data(), shares.size() * sizeof(float));
		RenderingServer::get_singleton()->texture_2d_update(blend_texture, blend_image, 0);
	}
}

} // namespace undergrowth

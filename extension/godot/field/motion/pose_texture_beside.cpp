// Data of plants in a PoseTexture besides their bends: rest directions, second modes, heights, and step lengths.

#include "field/motion/pose_texture.hpp"

#include <algorithm>
#include <cstring>

using namespace godot;

namespace undergrowth {

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

} // namespace undergrowth

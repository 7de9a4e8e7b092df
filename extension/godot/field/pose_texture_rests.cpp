// What a PoseTexture says of plants of parts besides their bends: where they rest, and how long their steps are.

#include "field/pose_texture.hpp"

#include <algorithm>
#include <cstring>

using namespace godot;

namespace undergrowth {

int PoseTexture::rest_layer(int layer) const {
	return size_t(layer) < rest_layers.size() ? rest_layers[size_t(layer)] : -1;
}

void PoseTexture::write_rests(const FieldSimulation &simulation, int page) {
	if (!has_rows(page) || !simulation.has_parts(page)) {
		return;
	}
	const Rows &rows = pages[size_t(page)].rows;
	std::vector<Bend> rests(2 * size_t(simulation.page(page).size()), 0);
	for (size_t i = 0; i < rests.size(); i += 2) {
		rests[i] = encode_bend(simulation.rest(page, int(i / 2)));
	}
	const bool are_upright = std::all_of(rests.begin(), rests.end(), [](Bend rest) { return rest == 0; });
	if (rest_layer(rows.layer) < 0) {
		if (are_upright || layers.size() >= size_t(MOST_LAYERS) - SPARE_LAYERS) {
			return;
		}
		rest_layers.resize(std::max(rest_layers.size(), size_t(rows.layer) + 1), -1);
		rest_layers[size_t(rows.layer)] = add_layer(false);
		std::memset(layers.back()->ptrw(), 0, PAIRS_PER_LAYER * TEXEL_BYTES);
	}
	const int layer = rest_layer(rows.layer);
	write_layer(layer, rests.data(), int(rests.size() / 2), rows.first * SIDE);
	pages[size_t(page)].interval = -1.0f;
	has_new_rows = true;
}

void PoseTexture::upload_beats(const FieldSimulation &simulation) {
	bool has_changed = false;
	has_new_rows = false;
	for (int number = 0; number < int(pages.size()); number++) {
		Page &page = pages[size_t(number)];
		if (!has_rows(number) || simulation.shown_interval(number) == page.interval) {
			continue;
		}
		page.interval = simulation.shown_interval(number);
		float *to = beats_sent.data() + 2 * (size_t(page.rows.layer) * SIDE + size_t(page.rows.first));
		for (int row = 0; row < page.rows.count; row++) {
			*to++ = 1.0f / page.interval;
			*to++ = float(rest_layer(page.rows.layer));
		}
		has_changed = true;
	}
	if (has_changed) {
		std::memcpy(beat_image->ptrw(), beats_sent.data(), beats_sent.size() * sizeof(float));
		RenderingServer::get_singleton()->texture_2d_update(beat_texture, beat_image, 0);
	}
}

} // namespace undergrowth

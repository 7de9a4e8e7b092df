#include "card/card_sheet.hpp"

#include "card/card_mips.hpp"

#include <algorithm>

namespace undergrowth {

namespace {

struct LayerSize {
	int width, height;
};
constexpr LayerSize SIZES[] = { { 128, 256 }, { 64, 256 }, { 96, 128 }, { 96, 96 }, { 80, 80 }, { 64, 64 },
	{ 32, 64 } };
constexpr float MANY = 0.75f; // Of the number of parts of the largest place.
constexpr int BYTES_OF_TEXEL = 8; // Of both textures.

/// Returns the place of a group that is shown: of those with many parts the one of middle size, because other places
/// scale its picture with all details.
int shown_place(const CardPlaces &all, int group) {
	std::vector<int> own;
	int most = 0;
	for (size_t i = 0; i < all.places.size(); i++) {
		const CardPlace &place = all.places[i];
		if (place.group == group && !place.extent.is_empty()) {
			own.push_back(static_cast<int>(i));
			most = std::max(most, place.count);
		}
	}
	const auto at = [&](int i) -> const CardPlace & { return all.places[static_cast<size_t>(i)]; };
	own.erase(std::remove_if(own.begin(), own.end(),
					  [&](int i) { return static_cast<float>(at(i).count) < MANY * static_cast<float>(most); }),
			own.end());
	std::stable_sort(own.begin(), own.end(), [&](int a, int b) { return at(a).extent.half < at(b).extent.half; });
	return own.empty() ? -1 : own[own.size() / 2];
}

std::vector<glm::vec2> edges_of(const CardPicture &picture) {
	std::vector<glm::vec2> edges;
	for (int row = picture.height - 1; row >= 0; row--) {
		glm::vec2 edge(1.0f, -1.0f);
		for (int column = 0; column < picture.width; column++) {
			if (picture.texels[static_cast<size_t>(row * picture.width + column)].coverage > 0.0f) {
				const float left = static_cast<float>(column - 1) / static_cast<float>(picture.width);
				const float right = static_cast<float>(column + 2) / static_cast<float>(picture.width);
				edge.x = std::min(edge.x, std::max(2.0f * left - 1.0f, -1.0f));
				edge.y = std::max(edge.y, std::min(2.0f * right - 1.0f, 1.0f));
			}
		}
		edges.push_back(edge);
	}
	return edges;
}

void add_layers(const PlantForm &form, const CardPlaces &all, int place, CardShape shape, CardSheet &sheet) {
	HeadOutline outline;
	const std::vector<CardPicture> pictures = draw_card(form, all, place, shape, sheet.width, sheet.height, outline);
	std::vector<CardLayer> made;
	for (const CardPicture &picture : pictures) {
		CardLayer layer;
		layer.box = picture.box;
		layer.extent = all.places[static_cast<size_t>(place)].extent;
		layer.head = outline;
		layer.edges = edges_of(picture);
		made.push_back(layer);
	}
	std::vector<CardLayer *> layers;
	for (CardLayer &layer : made) {
		layers.push_back(&layer);
	}
	write_layers(pictures, layers);
	sheet.pictures.insert(sheet.pictures.end(), made.begin(), made.end());
}

bool has_far(const std::vector<CardGroup> &groups) {
	return std::any_of(
			groups.begin(), groups.end(), [](const CardGroup &group) { return group.reach == CardReach::far; });
}

} // namespace

bool CardSheet::has_far_cards() const {
	return has_far(groups);
}

size_t CardSheet::size() const {
	size_t sum = 0;
	for (const CardLayer &layer : pictures) {
		sum += layer.colors.size() + layer.surfaces.size();
	}
	return sum;
}

float texel_of(const CardSheet &sheet) {
	float largest = 0.0f;
	for (const CardLayer &layer : sheet.pictures) {
		const float across = 2.0f * layer.box.half / static_cast<float>(sheet.width);
		const float along = (layer.box.high - layer.box.low) / static_cast<float>(sheet.height);
		largest = std::max({ largest, across, along });
	}
	return largest;
}

CardSheet make_card_sheet(const PlantForm &form) {
	CardSheet sheet;
	const std::vector<CardGroup> found = find_card_groups(form);
	const CardPlaces near = place_cards(form, found, CardReach::near);
	const CardPlaces far = has_far(found) ? place_cards(form, found, CardReach::far) : CardPlaces();
	const auto places_of = [&](const CardGroup &group) -> const CardPlaces & {
		return group.is_drawn(CardReach::near) ? near : far;
	};
	std::vector<int> shown;
	int layers = 0;
	for (size_t g = 0; g < found.size(); g++) {
		const int place = shown_place(places_of(found[g]), static_cast<int>(g));
		if (place >= 0) {
			sheet.groups.push_back(found[g]);
			sheet.layers.push_back(layers);
			shown.push_back(place);
			layers += found[g].layers();
		}
	}
	if (layers == 0) {
		return sheet;
	}
	for (const LayerSize &size : SIZES) {
		sheet.width = size.width;
		sheet.height = size.height;
		const int texels = layers * size.width * size.height * 4 / 3; // With mipmaps.
		if (static_cast<size_t>(texels * BYTES_OF_TEXEL) <= MAX_SHEET_BYTES) {
			break;
		}
	}
	for (size_t i = 0; i < shown.size(); i++) {
		add_layers(form, places_of(sheet.groups[i]), shown[i], sheet.groups[i].shape, sheet);
	}
	return sheet;
}

} // namespace undergrowth

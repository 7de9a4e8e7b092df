#pragma once

#include "card/card_groups.hpp"
#include "card/card_picture.hpp"

#include <cstdint>
#include <vector>

namespace undergrowth {

/// One picture of a sheet.
struct CardLayer {
	CardBox box; ///< Of the place that the picture shows.
	CardExtent extent; ///< Of the same place: other places scale the box by their own extent.
	glm::vec4 color = glm::vec4(0.0f); ///< Mean visible colour (sRGB) of its group.
	float leafiness = 0.0f;
	HeadOutline head; ///< Of heads.
	/// Covered columns, by row of texels from base to tip: from -1 to 1 across the box. Left > right: empty.
	std::vector<glm::vec2> edges;
	/// RGBA8 with all mipmaps. Colour relative to the mean, in linear light: (2·byte/255)². a: coverage.
	std::vector<uint8_t> colors;
	/// RGBA8 with all mipmaps. Normal across and along the card (0.5: none), occlusion relative to its mean (0.5: the
	/// mean), leafiness.
	std::vector<uint8_t> surfaces;
};

/// The pictures of all card groups of a species, from one of its plants. All seeds share them.
struct CardSheet {
	int width = 0; ///< Texels of each layer.
	int height = 0;
	std::vector<CardGroup> groups;
	std::vector<int> layers; ///< By group: its first layer.
	std::vector<CardLayer> pictures; ///< By layer.

	bool is_empty() const { return pictures.empty(); }
	/// True if coarse forms draw other cards than fine ones.
	bool has_far_cards() const;
	/// Bytes of all layers in video memory.
	size_t size() const;
};

/// Largest size of the layers of a sheet (bytes).
inline constexpr size_t MAX_SHEET_BYTES = 500000;

/// Empty if the plant has no groups for cards. The same bytes on all platforms.
CardSheet make_card_sheet(const PlantForm &form);

} // namespace undergrowth

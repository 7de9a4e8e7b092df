#pragma once

#include "card/card_axis.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Region of a card's plane that a picture shows (m). Its width is symmetric about the axis.
struct CardBox {
	float low = 0.0f; ///< Along the axis.
	float high = 1.0f;
	float half = 1.0f;
};

/// A texel of a picture, mean over its covered samples.
struct CardTexel {
	float coverage = 0.0f; ///< 0 to 1.
	glm::vec3 light = glm::vec3(0.0f); ///< Colour in linear light.
	glm::vec2 normal = glm::vec2(0.0f); ///< Across and along the card.
	float depth = 0.0f; ///< m, towards the camera.
	float leafiness = 0.0f;
};

/// The edges of a head in all of its pictures (m): of a solid of revolution with a lower and an upper rim.
struct HeadOutline {
	float middle = 0.0f; ///< Along the axis, from its origin.
	float half = 0.0f; ///< Largest distance across.
	glm::vec2 low = glm::vec2(0.0f); ///< See head_edge(). Along the axis from the middle.
	glm::vec2 high = glm::vec2(0.0f);
};

/// The pictures of the parts of one card, from its own uncut geometry. The same bytes on all platforms.
struct CardPicture {
	int width = 0;
	int height = 0;
	CardBox box;
	std::vector<CardTexel> texels; ///< Row by row, from the tip to the base.
};

/// Draws the pictures of all parts of a place with 6 by 6 samples per texel, the nearest in front: one, or those of a
/// head, and its `outline`. A border of one texel stays empty.
std::vector<CardPicture> draw_card(const PlantForm &form, const CardPlaces &all, int place, CardShape shape, int width,
		int height, HeadOutline &outline);

} // namespace undergrowth

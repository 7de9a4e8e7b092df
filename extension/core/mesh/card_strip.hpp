#pragma once

#include "mesh/part_attachment.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace undergrowth {

/// How a card is turned. The whole part of CUSTOM0.z contains it (mesh/vertex_format.hpp).
enum class CardTurn {
	fixed, ///< As written.
	turned, ///< About its axis to the camera.
	head, ///< To the camera, with pictures from several heights (HEAD_VIEWS).
};

/// Heights of the camera of the pictures of a head: sines of the angle above the plane across its axis, ascending.
/// Cards blend two of them. undergrowth_card.gdshaderinc has the same.
inline constexpr float HEAD_VIEWS[] = { -0.17f, 0.42f, 0.9f };
inline constexpr int HEAD_VIEW_COUNT = 3;

/// Share of the way between two pictures at whose ends the first and the second one are drawn alone. A picture that is
/// stretched to another height looks better than two that are mixed.
inline constexpr float HEAD_MIX = 0.3f;

/// Returns the picture for this height of the camera, from 0 to HEAD_VIEW_COUNT - 1. Its fraction is the share of the
/// next picture.
inline float head_picture(float sine) {
	float picture = 0.0f;
	for (int i = 0; i + 1 < HEAD_VIEW_COUNT; i++) {
		const float way = (sine - HEAD_VIEWS[i]) / (HEAD_VIEWS[i + 1] - HEAD_VIEWS[i]);
		const float share = std::clamp((way - HEAD_MIX) / (1.0f - 2.0f * HEAD_MIX), 0.0f, 1.0f);
		picture += share * share * (3.0f - 2.0f * share);
	}
	return picture;
}

/// Returns what is added to the coverage of two mixed pictures of a head: parts that only one of them shows cover too
/// little in the mean of both. `share`: of the second one.
inline float head_gain(float share) {
	return 0.08f * share * (1.0f - share);
}

/// Returns the height of the edge of a head in its picture (m). `edge`: m along its axis and away from it. Of all
/// solids of revolution with such an edge.
inline float head_edge(const glm::vec2 &edge, float sine) {
	return edge.x * std::sqrt(std::max(1.0f - sine * sine, 0.0f)) + edge.y * std::abs(sine);
}

/// A textured strip of quads in place of many small parts (card/card_sheet.hpp).
struct CardStrip {
	struct Row {
		glm::vec3 middle = glm::vec3(0.0f); ///< m, on the axis. In heads: the centre, in both rows.
		/// m from there to the vertex. In heads: across, and the edge of the row (head_edge) along the axis and
		/// `along`.
		glm::vec3 left = glm::vec3(0.0f);
		glm::vec3 right = glm::vec3(0.0f);
		glm::vec3 normal = glm::vec3(0.0f); ///< Of fixed strips; of all others the axis.
		glm::vec3 along = glm::vec3(0.0f); ///< From base to tip. In heads: a direction across the axis.
		glm::vec2 left_uv = glm::vec2(0.0f);
		glm::vec2 right_uv = glm::vec2(0.0f);
		float offset = 0.0f; ///< On the part with the attachment.
		PartAttachment attachment;
	};
	std::vector<Row> rows;
	glm::vec4 color = glm::vec4(1.0f); ///< Mean of its parts.
	float tint = 0.0f; ///< Tint of the carrier, -1 to 1.
	float leafiness = 0.0f;
	int layer = 0;
	CardTurn turn = CardTurn::fixed;

	int vertices() const { return 2 * static_cast<int>(rows.size()); }
	int indices() const { return 6 * (static_cast<int>(rows.size()) - 1); }
};

/// First whole part of CUSTOM0.z of cards; venations are below it.
inline constexpr int FIRST_CARD_CODE = 8;
/// Codes of one layer: as many as CardTurn has values, rounded up.
inline constexpr int CARD_CODES = 4;

inline float card_code(int layer, CardTurn turn) {
	return static_cast<float>(FIRST_CARD_CODE + CARD_CODES * layer + static_cast<int>(turn));
}

} // namespace undergrowth

#pragma once

#include "mesh/part_attachment.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace undergrowth {

/// How a card is turned. The whole part of CUSTOM0.z contains it (mesh/vertex_format.hpp).
enum class CardTurn {
	fixed, ///< As written.
	turned, ///< About its axis to the camera, and in a ball also towards it.
	cap, ///< As written, but drawn only from above.
	side, ///< Turned, and narrower where its cap is drawn.
};

/// A textured strip of quads in place of many small parts (card/card_sheet.hpp).
struct CardStrip {
	struct Row {
		glm::vec3 middle = glm::vec3(0.0f); ///< m, on the axis. In balls and caps: the centre, in all rows.
		glm::vec3 left = glm::vec3(0.0f); ///< m from there to the vertex.
		glm::vec3 right = glm::vec3(0.0f);
		glm::vec3 normal = glm::vec3(0.0f); ///< Of fixed strips; of all others the axis.
		glm::vec3 along = glm::vec3(0.0f); ///< From base to tip.
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

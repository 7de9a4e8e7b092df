#pragma once

#include "form/plant_form.hpp"
#include "plant/part_motion.hpp"

#include <vector>

namespace undergrowth {

/// Attachment of a part to the bending plant (mesh/vertex_format.hpp).
struct PartAttachment {
	/// True if it grows from the ground: the stem offset of its vertices comes from their own heights.
	bool is_root = false;
	float stem_offset = 0.0f; ///< Stem offset of all its vertices, if it is not a root.
	float stem_place = 0.0f; ///< Position of its attachment on the stem, if it is not a root.
	bool swings = false; ///< True if it swings by itself: the own weight of its vertices is their offset.
	bool has_swing = false; ///< True if it has a swing of its own, of its head or of its carrier.
	int swinger = -1; ///< Index of the placed part with that swing; for a head, its first part.
	float weight = 0.0f; ///< Own weight of all its vertices, if it does not swing.
	glm::vec3 pivot = glm::vec3(0.0f); ///< m.
	PartMotion swing; ///< The swing, from which `code` is made.
	PartMotionCode code; ///< The encoded swing of its vertices.
	float rank = 0.0f; ///< At least the rank of its carrier.

	/// Own weight at a part's offset.
	float weight_at(float offset) const { return swings ? offset : weight; }
	/// Returns the attachment of a body of many parts of which this is the first. Such a body has no swing of its own.
	PartAttachment of_body() const;
};

/// Returns the attachments of all placed parts. A part swings if it has a frequency and no carrier of it swings. All
/// short parts around and on the tip of a stem are a head: they share one swing, that of the softest part.
std::vector<PartAttachment> attach_parts(const PlantForm &form);

/// Returns the stem offset of a point of a part on the ground.
float stem_offset_of(const PlantForm &form, const glm::vec3 &point);

} // namespace undergrowth

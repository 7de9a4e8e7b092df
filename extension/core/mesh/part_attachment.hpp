#pragma once

#include "form/plant_form.hpp"
#include "plant/part_motion.hpp"

#include <array>
#include <vector>

namespace undergrowth {

/// A swing on another swing: that of a twig on its branch, or of a leaf on its twig.
struct InnerSwing {
	bool swings = false; ///< True for the part that swings: the weight of its vertices is their offset.
	int swinger = -1; ///< Index of the placed part with that swing.
	float weight = 0.0f; ///< Weight of all vertices, if it does not swing.
	glm::vec3 pivot = glm::vec3(0.0f); ///< m.
	PartMotion swing;
	PartMotionCode code;

	float weight_at(float offset) const { return swings ? offset : weight; }
};

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
	/// In plants with branches on swinging branches: the swings on `swing`, from the outermost to the innermost.
	std::array<InnerSwing, MAX_INNER_SWINGS> inner;
	int inner_count = 0;

	/// Own weight at a part's offset.
	float weight_at(float offset) const { return swings ? offset : weight; }
	/// The inner swings of what is attached at the offset of a part.
	std::array<InnerSwing, MAX_INNER_SWINGS> inner_at(float offset) const;
	/// Returns the attachment of a body of many parts of which this is the first. Such a body has no swing of its own.
	PartAttachment of_body() const;
};

/// Returns the attachments of all placed parts. A part swings if it has a frequency and no carrier of it swings. All
/// short parts around and on the tip of a stem are a head: they share one swing, that of the softest part. In plants
/// with branched branches, a part with a frequency on a swinging axis has an inner swing, in up to MAX_INNER_SWINGS
/// orders.
std::vector<PartAttachment> attach_parts(const PlantForm &form);

/// True if a swinging axis carries another one: then each order of branches has a swing of its own.
bool has_branched_branches(const PlantForm &form);

/// Returns the stem offset of a point of a part on the ground.
float stem_offset_of(const PlantForm &form, const glm::vec3 &point);

} // namespace undergrowth

#pragma once

#include "form/plant_form.hpp"
#include "plant/part_swing.hpp"

#include <vector>

namespace undergrowth {

/// Attachment of a part to the bending plant (mesh/vertex_format.hpp).
struct PartHang {
	/// True if the part is on the ground: the stem offset of its vertices follows from their own height.
	bool is_root = false;
	float stem_offset = 0.0f; ///< Of all vertices, except for a root.
	float stem_place = 0.0f; ///< Position of the attachment on the stem, except for a root.
	bool swings = false; ///< True if it swings by itself: the own weight of its vertices is their offset.
	bool has_swing = false; ///< True if it has its own swing, that of its head or that of its carrier.
	int swinger = -1; ///< Index of the placed part with that swing; for a head its first part.
	float weight = 0.0f; ///< Of all vertices, except if it swings.
	glm::vec3 pivot = glm::vec3(0.0f); ///< m.
	PartSwing swing; ///< The swing,
	SwingCode code; ///< encoded for vertices.
	float rank = 0.0f; ///< At least the rank of its carrier.

	/// Own weight at an offset of the part.
	float weight_at(float offset) const { return swings ? offset : weight; }
	/// Hang of a body of many parts that begins with this one. The parts swing separately; the body does not swing.
	PartHang of_body() const;
};

/// Returns the hang of all placed parts. A part with a frequency swings unless one of its carriers does. A head
/// consists of all short parts around and on the tip of a stem. It swings as a whole, like its softest part.
std::vector<PartHang> hang_parts(const PlantForm &form);

/// Stem offset of a point of a part on the ground.
float stem_offset_of(const PlantForm &form, const glm::vec3 &point);

} // namespace undergrowth

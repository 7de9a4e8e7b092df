#pragma once

#include "form/plant_form.hpp"
#include "plant/part_swing.hpp"

#include <vector>

namespace undergrowth {

/// How a part hangs on the plant that bends (mesh/vertex_format.hpp).
struct PartHang {
	bool is_root = false; ///< It stands on the ground: the stem offset of its vertices is their own height's.
	float stem_offset = 0.0f; ///< Of all its vertices, unless it is a root.
	float stem_place = 0.0f; ///< Where on the stem it is attached, unless it is a root.
	bool swings = false; ///< By itself: the own weight of its vertices is their offset.
	bool has_swing = false; ///< Its own, its head's, or that of what carries it.
	int swinger = -1; ///< Index of the placed part whose swing that is; of a head its first part.
	float weight = 0.0f; ///< Of all its vertices, unless it swings.
	glm::vec3 pivot = glm::vec3(0.0f); ///< m.
	PartSwing swing; ///< As vertices say it,
	SwingCode code; ///< in these words.
	float rank = 0.0f; ///< At least that of what carries it.

	/// The own weight at a part's offset.
	float weight_at(float offset) const { return swings ? offset : weight; }
	/// As a body of many parts hangs, of which this is the first: those swing each by itself, their body not at all.
	PartHang of_body() const;
};

/// Of all placed parts. Parts swing that have a frequency, where nothing swings that carries them. Of a head, that is
/// of all short parts around and on the tip of a stem, one swing turns the whole: that of its softest part.
std::vector<PartHang> hang_parts(const PlantForm &form);

/// The stem offset of a point of what stands on the ground.
float stem_offset_of(const PlantForm &form, const glm::vec3 &point);

} // namespace undergrowth

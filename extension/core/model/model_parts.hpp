#pragma once

#include "model/model_islands.hpp"
#include "plant/part_motion.hpp"

#include <array>

namespace undergrowth {

/// Middle of an island by height: what its vertices are scaled about (CUSTOM2 in mesh/vertex_format.hpp).
struct ModelMidrib {
	static constexpr int SLICES = 12;
	float least = 0.0f; ///< m, height of the first slice.
	float step = 1.0f; ///< m, > 0.
	std::array<glm::vec3, SLICES + 1> middles = {}; ///< m.
	std::array<float, SLICES + 1> radii = {}; ///< m: mean distance of the vertices from the middle.

	glm::vec3 at(float height) const;
};

/// How one island of a model moves with the plant (mesh/vertex_format.hpp).
struct ModelPart {
	/// True if it meets the ground, or is the lowest one: the stem offset of its vertices comes from their heights.
	bool is_root = false;
	float stem_offset = 0.0f; ///< Of all its vertices, if it is not a root: that of its attachment.
	bool swings = false; ///< True: the own weight of its vertices is their place between pivot and tip.
	float weight = 0.0f; ///< Own weight of all its vertices, if it does not swing: 1 in a head, 0 for a twig.
	int swinger = -1; ///< Island whose swing it has: its own, that of the first part of its head, or -1.
	glm::vec3 pivot = glm::vec3(0.0f); ///< m.
	glm::vec3 tip = glm::vec3(0.0f); ///< m: its end, on the line from the pivot through its middle.
	PartMotion swing;
	PartMotionCode code;
	ModelMidrib midrib; ///< Of a root.

	float length() const;
	/// Place of a vertex between pivot (0) and tip (1).
	float offset_of(const glm::vec3 &place) const;
	float weight_of(const glm::vec3 &place, float height) const;
	float stem_offset_of(const glm::vec3 &place, float height) const;
	glm::vec3 midrib_at(const glm::vec3 &place) const;
};

/// Finds what the islands of a model are. `height`: of the plant (m).
///
/// - Islands at the ground are roots. They bend along the height. If there are several, those beside the middle swing
///   as blades do.
/// - All other islands are attached where they are nearest to a root or to a twig, and swing about that point as
/// leaves.
/// - A twig is a large loose island that carries others. It moves with the stem.
/// - Small islands together around the tip of a root are a head and turn as one.
///
/// Swings depend on the place of an island only, so that levels of one plant move alike.
std::vector<ModelPart> attach_islands(const std::vector<ModelSurface> &surfaces, const std::vector<glm::vec3> &places,
		const ModelIslands &found, float height);

} // namespace undergrowth

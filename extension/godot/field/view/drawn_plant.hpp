#pragma once

#include "placement/lod_density.hpp"

#include <glm/vec3.hpp>

#include <cstdint>

namespace undergrowth {

/// What all levels of detail of a plant have in common: 32 bytes, half of an instance in a multimesh.
struct DrawnPlant {
	glm::vec3 root = glm::vec3(0.0f); ///< m.
	float scale = 1.0f;
	float height = 0.0f; ///< m.
	uint32_t rank_code : RANK_BITS; ///< Rank times RANK_COUNT.
	uint32_t variant : 32 - RANK_BITS; ///< Less than the number of the species' variants.
	uint16_t turn = 0; ///< As in FieldPlants.
	int16_t texel = 0, layer = 0; ///< Location of its pose, as stored in instances.
	int8_t lightness = 0, warmth = 0; ///< Of its color, as in FieldPlants.

	DrawnPlant() : rank_code(0), variant(0) {}
	float rank() const { return float(rank_code) / float(RANK_COUNT); }
	/// Writes the floats of an instance that draws it with a mesh of `mesh_height` (m), and returns the position after
	/// them. `stride`: FLOATS or FLOATS_WITH_COLORS of FieldRenderSetup.
	float *write(int stride, float mesh_height, float *to) const;
};

static_assert(sizeof(DrawnPlant) == 32);

} // namespace undergrowth

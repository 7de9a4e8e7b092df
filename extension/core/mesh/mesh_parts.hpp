#pragma once

#include "mesh/plant_mesh.hpp"
#include "mesh/ring_placer.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

/// The parts of build_mesh(), see there. Both write everything except bones.
void build_smooth_mesh(const PlantSample &sample, const RingPlacer &placer, const MeshBuffers &buffers);
void build_flat_mesh(const PlantSample &sample, const RingPlacer &placer, const MeshBuffers &buffers);

/// Writes (0, 1, 0, 0) for each vertex.
void write_bones(int vertices, int32_t *bones);

/// Writes (1 - w, w, 0, 0) for `vertices` vertices of one height.
void write_weights(int vertices, float w, float *weights);

/// Returns the unit normal of a surface that faces `outward` horizontally and leans back by `rise`: outward motion of
/// the surface per metre of height.
inline glm::vec3 leaning_normal(glm::vec2 outward, float rise) {
	// Practically horizontal; the limit prevents an infinite square.
	const float y = std::clamp(-rise, -1e9f, 1e9f);
	const float shrink = 1.0f / std::sqrt(1.0f + y * y);
	return { outward.x * shrink, y * shrink, outward.y * shrink };
}

} // namespace undergrowth

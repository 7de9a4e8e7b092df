#pragma once

#include "mesh/cross_section.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>

namespace undergrowth {

enum class Shading {
	smooth, ///< One normal per point of a ring (Gouraud; thesis, section 5.1.1).
	flat, ///< One normal per triangle, as in the thesis; triangles share no vertices.
};

/// A plant sampled at lod + 1 equal heights.
struct PlantSample {
	const CrossSection *cross_section = nullptr; ///< At most MAX_RING_POINTS points (plant/base_shape.hpp).
	const float *widths = nullptr; ///< lod + 1 factors of the ring, each finite and >= 0.
	const glm::vec4 *colors = nullptr; ///< lod + 1 colours.
	float height = 1.0f; ///< m, > 0.
	int lod = 8; ///< Vertical segments, MIN_LOD to MAX_LOD.
};

struct MeshOptions {
	Shading shading = Shading::smooth;
	float shape_deviation = 0.0f; ///< 0 to 1: deviation of rings from symmetry (thesis, section 5.1.1; deviation.hpp).
	float color_deviation = 0.0f; ///< 0 to 1: variation of colours.
	uint64_t seed = 0; ///< Selects the deviations; unused if both are 0.
};

struct MeshCounts {
	int vertices = 0;
	int indices = 0; ///< Three per triangle.
};

/// Output arrays of a mesh, with the sizes of count_mesh(); none is null. Bones and weights have four entries per
/// vertex.
struct MeshBuffers {
	glm::vec3 *positions = nullptr;
	glm::vec3 *normals = nullptr;
	glm::vec4 *colors = nullptr;
	glm::vec2 *uvs = nullptr; ///< u around the ring from 0 to 1, v from 1 at the ground to 0 at the tip.
	int32_t *bones = nullptr; ///< Always (0, 1, 0, 0): root and tip.
	float *weights = nullptr; ///< (1 - w, w, 0, 0) with w = vertex height / plant height (thesis, formula 4.1).
	int32_t *indices = nullptr;
};

/// Returns the sizes for a ring of `points` points and `lod` segments; they do not depend on shape and colours. Smooth:
/// (lod + 1)·(points + 1) side vertices (the last column repeats the first for the uv seam) and `points` for each of
/// the two ends. Flat: three vertices per triangle. Both: 2·points·lod side triangles and points - 2 for each end.
MeshCounts count_mesh(int points, int lod, Shading shading);

/// Builds rings, sides and both ends (thesis, section 2.2, snippets 2.1 and 2.2, with `lod` bands). Ring k is exactly
/// at height·k/lod and is the cross-section times widths[k]. Order of indices: sides by band, then the bottom, then the
/// top. Allocates nothing.
///
/// Side quads are the triangles (0, 1, 2) and (1, 3, 2), clockwise from outside. 0 is lower i, 1 upper i, 2 lower next,
/// 3 upper next. (The thesis lists each as (0, 2, 1) and (1, 2, 3). With its ring and right-handed axes that is WebGL's
/// front face, counter-clockwise; Godot's is clockwise.)
///
/// Guarantees: indices in range, normals outward and of length 1 within 1e-6, weights that sum to 1 exactly, a closed
/// surface after welding, the same bytes for the same arguments.
void build_mesh(const PlantSample &sample, const MeshOptions &options, const MeshBuffers &buffers);

} // namespace undergrowth

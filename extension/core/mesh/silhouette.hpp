#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace undergrowth {

/// Plants are viewed level from eight sides; opposite sides see the same outline.
inline constexpr size_t OUTLINES = 4;
/// One number for each outline.
using Outlines = std::array<float, OUTLINES>;

/// Directions along the ground that run across the picture of each outline. Its viewing direction is (-sine, 0,
/// cosine).
inline constexpr Outlines OUTLINE_COSINES = { 1.0f, 0.70710678f, 0.0f, -0.70710678f };
inline constexpr Outlines OUTLINE_SINES = { 0.0f, 0.70710678f, 1.0f, 0.70710678f };

/// Bounds of a plant: a cylinder about its axis. Pictures of the plant and of its levels have dots of one size, a fixed
/// number per box. Levels that extend beyond the box use larger pictures, up to three times as large.
struct SightBox {
	float reach = 0.0f; ///< m from the axis.
	float low = 0.0f; ///< m, heights.
	float top = 0.0f;

	void take_in(const glm::vec3 &point);
	bool is_empty() const { return !(reach > 0.0f) || !(top > low); }
};

/// A mesh to view.
struct SeenMesh {
	const glm::vec3 *positions = nullptr;
	int vertex_count = 0;
	const int32_t *indices = nullptr;
	int index_count = 0;
};

/// m² that a mesh covers in each outline; parts behind other parts do not count again.
Outlines outline_areas(const SeenMesh &mesh, const SightBox &box);

/// m² that a mesh covers from straight above.
float area_from_above(const SeenMesh &mesh);

/// Weight of each vertex's colour in the mean colour that a distant camera sees, over all eight sides. Nearer triangles
/// hide farther ones; all have the same light. The weights sum to 1, or are all 0 if nothing is visible.
std::vector<float> seen_shares(const SeenMesh &mesh, const SightBox &box);

/// Converts a component of an authored colour to linear light and back, within 2e-3. These are polynomials because the
/// exact curve has powers.
inline float to_light(float component) {
	return component * (component * (component * 0.305306011f + 0.682171111f) + 0.012522878f);
}
float from_light(float light);
/// The same for `count` values, in place.
void from_light(float *lights, int count);

} // namespace undergrowth

#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace undergrowth {

/// Plants are viewed horizontally from eight sides; opposite sides have the same outline.
inline constexpr size_t OUTLINES = 4;
/// One number for each outline.
using Outlines = std::array<float, OUTLINES>;

/// The horizontal directions across each outline's picture; the view is along (-sine, 0, cosine).
inline constexpr Outlines OUTLINE_COSINES = { 1.0f, 0.70710678f, 0.0f, -0.70710678f };
inline constexpr Outlines OUTLINE_SINES = { 0.0f, 0.70710678f, 1.0f, 0.70710678f };

/// Extent of a plant: a cylinder about its axis. Pictures of the plant and of its levels have dots of one size, with a
/// fixed number per box. Levels that exceed the box get pictures up to three times as large.
struct SightBox {
	float reach = 0.0f; ///< m from the axis.
	float low = 0.0f; ///< m, heights.
	float top = 0.0f;

	void take_in(const glm::vec3 &point);
	bool is_empty() const { return !(reach > 0.0f) || !(top > low); }
};

/// Input mesh of a view.
struct SeenMesh {
	const glm::vec3 *positions = nullptr;
	int vertex_count = 0;
	const int32_t *indices = nullptr;
	int index_count = 0;
};

/// Returns the area of a mesh in each outline (m²), with occlusion.
Outlines outline_areas(const SeenMesh &mesh, const SightBox &box);

/// Returns its area from straight above (m²).
float area_from_above(const SeenMesh &mesh);

/// Returns the weight of each vertex's colour in the mean colour for a distant camera 17° above, over four sides, with
/// occlusion, under even light. The weights sum to 1, or are all 0 if nothing is visible.
std::vector<float> seen_shares(const SeenMesh &mesh, const SightBox &box);

/// Converts a colour component from the author's (sRGB) values to linear light, and from_light() back, within 2e-3.
/// Polynomials, because the exact curve needs powers.
inline float to_light(float component) {
	return component * (component * (component * 0.305306011f + 0.682171111f) + 0.012522878f);
}
float from_light(float light);
/// The same for an array, in place.
void from_light(float *lights, int count);

} // namespace undergrowth

#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace undergrowth {

/// Plants are looked at level from eight sides; opposite ones see the same outline.
inline constexpr size_t OUTLINES = 4;
/// One number for each outline.
using Outlines = std::array<float, OUTLINES>;

/// The directions along the ground that run across each outline's picture; it is seen along (-sine, 0, cosine).
inline constexpr Outlines OUTLINE_COSINES = { 1.0f, 0.70710678f, 0.0f, -0.70710678f };
inline constexpr Outlines OUTLINE_SINES = { 0.0f, 0.70710678f, 1.0f, 0.70710678f };

/// Where a plant is: a cylinder about its axis. Pictures of it and of its levels have dots of one size, so many to a
/// box; levels that go farther are seen on larger pictures, up to three times as large.
struct SightBox {
	float reach = 0.0f; ///< m from the axis.
	float low = 0.0f; ///< m, heights.
	float top = 0.0f;

	void take_in(const glm::vec3 &point);
	bool is_empty() const { return !(reach > 0.0f) || !(top > low); }
};

/// A mesh to be looked at.
struct SeenMesh {
	const glm::vec3 *positions = nullptr;
	int vertex_count = 0;
	const int32_t *indices = nullptr;
	int index_count = 0;
};

/// m² that a mesh covers in each outline; what lies behind other parts counts once.
Outlines outline_areas(const SeenMesh &mesh, const SightBox &box);

/// m² that it covers seen from straight above.
float area_from_above(const SeenMesh &mesh);

/// By how much each vertex's colour counts in the mean colour that a camera far away sees, over all eight sides,
/// nearer triangles before others, all lit the same. They sum to 1, or are all 0 where nothing is seen.
std::vector<float> seen_shares(const SeenMesh &mesh, const SightBox &box);

/// A colour's component, as authors write it, in linear light and back, within 2e-3. Polynomials, for the exact curve
/// has powers.
inline float to_light(float component) {
	return component * (component * (component * 0.305306011f + 0.682171111f) + 0.012522878f);
}
float from_light(float light);
/// The same for many at once, in their place.
void from_light(float *lights, int count);

} // namespace undergrowth

#pragma once

#include "climb/climb_chunks.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace undergrowth {

/// Tubes: triangles are clockwise as seen from outside.
struct StemMesh {
	std::vector<glm::vec3> positions; ///< m.
	std::vector<glm::vec3> normals;
	std::vector<glm::vec4> colors; ///< rgb: from old to young wood. a: 1.
	std::vector<glm::vec2> uvs; ///< x around the stem, y along it in metres.
	std::vector<int> indices;
};

/// Detail and colours of stems.
struct StemStyle {
	int sides = 5; ///< 3 to 16.
	float tolerance = 0.002f; ///< m: points that are closer to the straight line are left out.
	float thinnest = 0.0f; ///< m: runs with smaller radii are left out.
	glm::vec4 old_wood = { 0.33f, 0.27f, 0.2f, 1.0f };
	glm::vec4 young_wood = { 0.4f, 0.43f, 0.2f, 1.0f };
};

/// Builds the tubes of a chunk's runs.
StemMesh build_stems(const Climb &climb, const std::vector<StemRun> &runs, const StemStyle &style);

} // namespace undergrowth

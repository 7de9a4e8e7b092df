#pragma once

#include "model/model_surface.hpp"

namespace undergrowth {

/// A connected part of a surface.
struct ModelIsland {
	int surface = 0;
	int first = 0; ///< In ModelIslands::members.
	int count = 0; ///< Vertices.
	glm::vec3 least = glm::vec3(0.0f);
	glm::vec3 greatest = glm::vec3(0.0f);
	float area = 0.0f; ///< m².
	bool is_foliage = false;

	glm::vec3 centre() const { return 0.5f * (least + greatest); }
};

/// The connected parts of all surfaces. Vertices are numbered through all surfaces.
struct ModelIslands {
	std::vector<ModelIsland> islands; ///< By their first vertex.
	std::vector<int> of_vertex; ///< Island of each vertex; -1: no triangle uses it.
	std::vector<int> members; ///< Vertices by island.
};

/// Finds islands. Vertices of one surface at one place are connected, so that seams of UVs and edges of flat shading do
/// not separate. `places`: of all vertices, in the plant's axes (m).
ModelIslands find_islands(const std::vector<ModelSurface> &surfaces, const std::vector<glm::vec3> &places);

} // namespace undergrowth

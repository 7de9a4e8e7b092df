#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// One surface of a model: a mesh that a user made. Positions are in the axes and the unit of its file until a
/// ModelFrame transforms them.
struct ModelSurface {
	const glm::vec3 *positions = nullptr;
	int vertices = 0;
	const int32_t *indices = nullptr; ///< Three per triangle.
	int index_count = 0;
	const glm::vec4 *colors = nullptr; ///< Of the vertices; null: none.
	bool is_foliage = false; ///< True if its material is cut out, as that of leaf cards.
};

/// What the channels of vertex colours mean: 0 to 3 for red to alpha; -1: no channel.
struct ModelColors {
	int bend = -1; ///< Factor of the stem's bend: 0 is stiff, 1 bends as found.
	int flutter = -1; ///< Factor of the own swing of leaves and heads.
	int phase = -1; ///< Phase of that swing: the mean of its part.
};

enum class ModelFault {
	none,
	no_surface, ///< No surface has triangles.
	empty_surface, ///< A surface has no triangles.
	not_finite,
	bad_index, ///< A triangle refers to a vertex that does not exist.
	no_height, ///< All vertices lie in one point.
	too_large, ///< More than MAX_MODEL_VERTICES.
};

inline constexpr int MAX_MODEL_VERTICES = 2000000;

/// Error and remedy, in English.
const char *describe(ModelFault fault);

/// Returns the first fault of the surfaces, in the order of the enumeration.
ModelFault find_model_fault(const std::vector<ModelSurface> &surfaces);

} // namespace undergrowth

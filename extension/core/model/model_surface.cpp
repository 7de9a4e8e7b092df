#include "model/model_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace undergrowth {

const char *describe(ModelFault fault) {
	switch (fault) {
		case ModelFault::none:
			return "";
		case ModelFault::no_surface:
			return "It contains no triangles. Use a file with at least one mesh.";
		case ModelFault::empty_surface:
			return "A surface of its mesh contains no triangles. Remove the surface, or export the file again.";
		case ModelFault::not_finite:
			return "A vertex of its mesh is not finite (NaN or infinite). Export the file again.";
		case ModelFault::bad_index:
			return "A triangle of its mesh uses a vertex that does not exist. Export the file again.";
		case ModelFault::no_height:
			return "All vertices of its mesh lie in one point. Check the scale of the file.";
		case ModelFault::too_large:
			return "Its mesh has more than 2,000,000 vertices. Reduce it before the export.";
	}
	return "";
}

namespace {

constexpr float MIN_EXTENT = 1e-6f; // In the file's unit.

bool is_finite(const glm::vec3 &point) {
	return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

bool has_bad_index(const ModelSurface &surface) {
	return std::any_of(surface.indices, surface.indices + surface.index_count,
			[&](int32_t index) { return index < 0 || index >= surface.vertices; });
}

// The longest side of the box around all vertices.
float extent_of(const std::vector<ModelSurface> &surfaces) {
	float longest = 0.0f;
	for (int axis = 0; axis < 3; axis++) {
		float least = surfaces[0].positions[0][axis];
		float greatest = least;
		for (const ModelSurface &surface : surfaces) {
			for (int i = 0; i < surface.vertices; i++) {
				least = std::min(least, surface.positions[i][axis]);
				greatest = std::max(greatest, surface.positions[i][axis]);
			}
		}
		longest = std::max(longest, greatest - least);
	}
	return longest;
}

} // namespace

ModelFault find_model_fault(const std::vector<ModelSurface> &surfaces) {
	if (surfaces.empty()) {
		return ModelFault::no_surface;
	}
	int64_t vertices = 0;
	for (const ModelSurface &surface : surfaces) {
		if (surface.vertices < 3 || surface.index_count < 3) {
			return ModelFault::empty_surface;
		}
		if (!std::all_of(surface.positions, surface.positions + surface.vertices, is_finite)) {
			return ModelFault::not_finite;
		}
		if (surface.index_count % 3 != 0 || has_bad_index(surface)) {
			return ModelFault::bad_index;
		}
		vertices += surface.vertices;
	}
	if (!(extent_of(surfaces) > MIN_EXTENT)) {
		return ModelFault::no_height;
	}
	return vertices > MAX_MODEL_VERTICES ? ModelFault::too_large : ModelFault::none;
}

} // namespace undergrowth

#pragma once

#include "mesh/silhouette.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace undergrowth {

/// What the outline of a mesh with cards depends on besides its triangles; see mesh/vertex_format.hpp.
struct SeenCards {
	const glm::vec3 *normals = nullptr; ///< By vertex, as the following ones.
	const glm::vec4 *tangents = nullptr;
	const glm::vec2 *uvs = nullptr;
	const glm::vec4 *custom0 = nullptr;
	const glm::vec4 *custom2 = nullptr;
	int width = 0; ///< Texels of each layer.
	int height = 0;
	std::vector<const uint8_t *> layers; ///< RGBA8; a: coverage. From the tip to the base.
};

/// The outlines of a plant from several directions, for the comparison with its levels of detail. The same bytes on
/// all platforms.
class LevelError {
public:
	/// Views of a mesh with all parts. `seen` must stay valid during the constructor only.
	explicit LevelError(const SeenMesh &whole);

	/// Returns the error of a level's outline (m): 95 % of the drawn dots of both meshes are at most this far from the
	/// other mesh. All heights count the same, because flowers above the leaves are few dots but seen first. At least
	/// half a dot. 0 for an empty plant; the level needs the same axes.
	float of(const SeenMesh &level) const;
	/// The same for a level with cards, turned to each view.
	float of(const SeenMesh &level, const SeenCards &cards) const;
	/// Size of a dot (m). Smaller errors are not measured.
	float dot() const { return dot_size; }

private:
	/// The dots of one view, and the distance of each dot to the nearest covered one.
	struct View {
		int columns = 0;
		int rows = 0;
		float left = 0.0f; ///< m in the view's plane, of the first dot.
		float low = 0.0f;
		std::vector<uint16_t> away;
	};

	std::vector<View> views;
	float dot_size = 0.0f;

	float measure(const SeenMesh &level, const SeenCards *cards) const;
};

} // namespace undergrowth

#pragma once

#include "mesh/silhouette.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace undergrowth {

/// Projects the points of a mesh to the dots of a picture.
class SightLens {
public:
	/// Pictures with dots of a size at which `columns` by `rows` of them cover the box.
	SightLens(const SeenMesh &p_mesh, const SightBox &box, int columns, int rows);

	int columns() const { return 2 * half; }
	int rows() const { return height; }
	/// Area of a dot (m²).
	float dot_area() const { return 1.0f / (across * up); }

	/// A corner in dots, and its distance (m).
	struct Corner {
		float x, y, depth;
	};
	/// A triangle that covers row centres. Its rows are the same from all sides.
	struct Triangle {
		int32_t corners[3]; ///< From lowest to highest.
		int begin, end; ///< Rows.
		int first; ///< Index of its first corner in the mesh's indices.
	};
	/// In the order of the mesh; all other triangles are never visible.
	const std::vector<Triangle> &triangles() const { return upright; }
	/// Projects all points for one outline.
	void set_view(size_t side);
	const Corner &corner(int32_t vertex) const { return corners[static_cast<size_t>(vertex)]; }

private:
	static constexpr float MAX_ENLARGEMENT = 3.0f;

	const SeenMesh &mesh;
	float across, up; ///< Dots per metre.
	float low = 0.0f; ///< Dots below the box.
	float ground; ///< Lower end of the box (m).
	int half, height;
	std::vector<Corner> corners;
	std::vector<Triangle> upright;

	void find_triangles();
};

/// Returns the first dot with its centre beyond a position.
inline int first_beyond(float place) {
	return static_cast<int>(std::clamp(place, 0.0f, 1e6f) + 0.5f);
}

/// The edges of a triangle as a lens shows it from one side.
class TriangleEdges {
public:
	TriangleEdges(const SightLens &lens, const SightLens::Triangle &triangle) :
			low(lens.corner(triangle.corners[0])),
			middle(lens.corner(triangle.corners[1])),
			whole(slope(low, lens.corner(triangle.corners[2]))),
			lower(slope(low, middle)),
			upper(slope(middle, lens.corner(triangle.corners[2]))) {}

	/// Returns the columns of a row with centres inside the triangle.
	void columns(int row, int count, int &first, int &beyond) const {
		const float level = static_cast<float>(row) + 0.5f;
		const float a = low.x + whole * (level - low.y);
		const float b = level < middle.y ? low.x + lower * (level - low.y) : middle.x + upper * (level - middle.y);
		first = first_beyond(std::min(a, b));
		beyond = std::min(first_beyond(std::max(a, b)), count);
	}

private:
	const SightLens::Corner &low, &middle;
	const float whole, lower, upper;

	static float slope(const SightLens::Corner &from, const SightLens::Corner &to) {
		const float rise = to.y - from.y;
		return rise > 0.0f ? (to.x - from.x) / rise : 0.0f;
	}
};

} // namespace undergrowth

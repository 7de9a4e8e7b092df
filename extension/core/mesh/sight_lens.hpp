#pragma once

#include "mesh/silhouette.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace undergrowth {

/// Projects the points of a mesh to the dots (pixels) of a picture, and determines the size of the picture.
class SightLens {
public:
	/// For pictures whose dots are so large that `columns` by `rows` of them cover the box.
	SightLens(const SeenMesh &p_mesh, const SightBox &box, int columns, int rows);

	int columns() const { return 2 * half; }
	int rows() const { return height; }
	/// m² that a dot covers.
	float dot_area() const { return 1.0f / (across * up); }

	/// A corner in dots, and its depth (m).
	struct Corner {
		float x, y, depth;
	};
	/// A triangle that covers centres of rows. Its height is the same from all sides.
	struct Triangle {
		int32_t corners[3]; ///< From the lowest to the highest.
		int begin, end; ///< Rows.
		int first; ///< Index of its first corner in the mesh's indices.
	};
	/// In the order of the mesh. All other triangles are invisible.
	const std::vector<Triangle> &triangles() const { return standing; }
	/// Projects all points as in the picture of one outline.
	void look_from(size_t side);
	const Corner &corner(int32_t vertex) const { return corners[static_cast<size_t>(vertex)]; }

private:
	static constexpr float MOST_LARGER = 3.0f;

	const SeenMesh &mesh;
	float across, up; ///< Dots per metre.
	float low = 0.0f; ///< Dots below the box.
	float ground; ///< m, the bottom of the box.
	int half, height;
	std::vector<Corner> corners;
	std::vector<Triangle> standing;

	void find_triangles();
};

/// The first dot with its centre beyond a position.
inline int first_beyond(float place) {
	return static_cast<int>(std::clamp(place, 0.0f, 1e6f) + 0.5f);
}

/// The edges of a triangle as a lens projects them from one side.
class TriangleEdges {
public:
	TriangleEdges(const SightLens &lens, const SightLens::Triangle &triangle) :
			low(lens.corner(triangle.corners[0])),
			middle(lens.corner(triangle.corners[1])),
			whole(slope(low, lens.corner(triangle.corners[2]))),
			lower(slope(low, middle)),
			upper(slope(middle, lens.corner(triangle.corners[2]))) {}

	/// The columns whose centres the triangle covers in a row.
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

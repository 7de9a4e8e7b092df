#pragma once

#include "mesh/silhouette.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace undergrowth {

/// How a mesh's points come to the dots of a picture, and how many there are.
class SightLens {
public:
	/// Pictures whose dots are so large that `columns` by `rows` show the box.
	SightLens(const SeenMesh &p_mesh, const SightBox &box, int columns, int rows);

	int columns() const { return 2 * half; }
	int rows() const { return height; }
	/// m² that a dot covers.
	float dot_area() const { return 1.0f / (across * up); }

	/// A corner in dots, and how far away it is (m).
	struct Corner {
		float x, y, depth;
	};
	/// All points as one outline's picture shows them.
	void look_from(size_t side);
	const Corner &corner(int32_t vertex) const { return corners[static_cast<size_t>(vertex)]; }

private:
	static constexpr float MOST_LARGER = 3.0f;

	const SeenMesh &mesh;
	float across, up; ///< Dots a metre.
	float low = 0.0f; ///< Dots: what lies below the box.
	float ground; ///< m, the box's low.
	int half, height;
	std::vector<Corner> corners;
};

/// Rows of a picture whose middles a triangle covers: edge(row) of each are its left and right ends in dots.
class TriangleRows {
public:
	TriangleRows(const SightLens::Corner &a, const SightLens::Corner &b, const SightLens::Corner &c, int rows) :
			corners{ &a, &b, &c } {
		begin = first_beyond(std::min(std::min(a.y, b.y), c.y));
		end = std::min(rows, first_beyond(std::max(std::max(a.y, b.y), c.y)));
		if (begin < end) { // Of small triangles most lie between two rows.
			sort(0, 1);
			sort(1, 2);
			sort(0, 1);
			whole = slope(0, 2);
			lower = slope(0, 1);
			upper = slope(1, 2);
		}
	}

	int begin, end;

	/// The columns whose middles it covers in a row.
	void columns(int row, int count, int &first, int &beyond) const {
		const float level = static_cast<float>(row) + 0.5f;
		const SightLens::Corner &middle = *corners[1];
		const float a = corners[0]->x + whole * (level - corners[0]->y);
		const float b = level < middle.y ? corners[0]->x + lower * (level - corners[0]->y)
										 : middle.x + upper * (level - middle.y);
		first = first_beyond(std::min(a, b));
		beyond = std::min(first_beyond(std::max(a, b)), count);
	}

private:
	const SightLens::Corner *corners[3];
	float whole = 0.0f, lower = 0.0f, upper = 0.0f;

	/// The first dot whose middle is beyond a place.
	static int first_beyond(float place) { return static_cast<int>(std::clamp(place, 0.0f, 1e6f) + 0.5f); }
	void sort(int i, int k) {
		if (corners[k]->y < corners[i]->y) {
			std::swap(corners[i], corners[k]);
		}
	}
	float slope(int i, int k) const {
		const float rise = corners[k]->y - corners[i]->y;
		return rise > 0.0f ? (corners[k]->x - corners[i]->x) / rise : 0.0f;
	}
};

} // namespace undergrowth

// Colours of meshes, seen from a little above.

#include "mesh/sight_lens.hpp"

#include <memory>

namespace undergrowth {

namespace {

constexpr int COLUMNS = 96; // Per box.
constexpr int ROWS = 128;
constexpr size_t VIEWS = 4;
/// Horizontal directions of the views, at about equal angles.
constexpr float COSINES[VIEWS] = { 1.0f, -0.70710678f, 0.0f, 0.70710678f };
constexpr float SINES[VIEWS] = { 0.0f, -0.70710678f, 1.0f, -0.70710678f };
/// Height of the camera: 17° above.
constexpr float RISE_SINE = 0.292f;
constexpr float RISE_COSINE = 0.956f;

/// Turns a mesh so that set_view(0) of a lens shows this view.
void turn_to(size_t view, const SeenMesh &mesh, std::vector<glm::vec3> &points) {
	for (int i = 0; i < mesh.vertex_count; i++) {
		const glm::vec3 &point = mesh.positions[i];
		const float away = point.z * COSINES[view] - point.x * SINES[view];
		points[static_cast<size_t>(i)] = { point.x * COSINES[view] + point.z * SINES[view],
			point.y * RISE_COSINE + away * RISE_SINE, away * RISE_COSINE - point.y * RISE_SINE };
	}
}

/// The box around all turned points of a box.
SightBox turned_box(const SightBox &box) {
	const float side = box.reach * RISE_SINE;
	return { box.reach, box.low * RISE_COSINE - side, box.top * RISE_COSINE + side };
}

/// The nearest triangle at each dot.
class Sight {
public:
	Sight(int columns, int p_rows) : width(columns), rows(static_cast<size_t>(p_rows)), dots(new Dot[size()]) {}

	/// Prepares dots of a row for writing: clears those that were not used before.
	void reach(int row, int first, int end) {
		Row &own = rows[static_cast<size_t>(row)];
		if (own.first >= own.end) {
			own = { first, first };
		}
		clear(row, first, own.first);
		clear(row, own.end, end);
		own = { std::min(first, own.first), std::max(end, own.end) };
	}
	void put(int row, int column, float depth, int triangle) {
		Dot &dot = dots[place(row, column)];
		if (depth < dot.nearest) {
			dot.nearest = depth;
			dot.front = triangle;
		}
	}
	/// Calls `visit(triangle, x, y)` for what is visible, and clears it.
	template <class Visit> void take(const Visit &visit) {
		for (size_t row = 0; row < rows.size(); row++) {
			const float y = static_cast<float>(row) + 0.5f;
			for (int column = rows[row].first; column < rows[row].end; column++) {
				const Dot &dot = dots[place(static_cast<int>(row), column)];
				if (dot.front >= 0) {
					visit(dot.front, static_cast<float>(column) + 0.5f, y);
				}
			}
			rows[row] = Row();
		}
	}

private:
	struct Dot {
		float nearest;
		int front; ///< Index of a triangle.
	};
	/// Used columns.
	struct Row {
		int first = 0;
		int end = 0;
	};
	const int width;
	std::vector<Row> rows;
	const std::unique_ptr<Dot[]> dots; ///< Undefined where nothing was written.

	size_t size() const { return static_cast<size_t>(width) * rows.size(); }
	size_t place(int row, int column) const { return static_cast<size_t>(row * width + column); }
	void clear(int row, int first, int end) {
		for (int column = first; column < end; column++) {
			dots[place(row, column)] = { 1e30f, -1 };
		}
	}
};

/// Barycentric weights of a triangle's corners at positions in its plane.
struct Shares {
	float x, y; ///< Of the first corner, in dots.
	float b_x, b_y, c_x, c_y; ///< Of the remaining corners, per dot.

	Shares() = default;
	Shares(const SightLens::Corner &a, const SightLens::Corner &b, const SightLens::Corner &c) : x(a.x), y(a.y) {
		const float twice = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
		const float scale = twice != 0.0f ? 1.0f / twice : 0.0f;
		b_x = (c.y - a.y) * scale;
		b_y = (a.x - c.x) * scale;
		c_x = (a.y - b.y) * scale;
		c_y = (b.x - a.x) * scale;
	}
	void at(float px, float py, float (&out)[3]) const {
		out[1] = b_x * (px - x) + b_y * (py - y);
		out[2] = c_x * (px - x) + c_y * (py - y);
		out[0] = 1.0f - out[1] - out[2];
	}
};

/// Computes the weights of a triangle's corners in the present view.
Shares shares_of(const SightLens &lens, const int32_t *at) {
	return Shares(lens.corner(at[0]), lens.corner(at[1]), lens.corner(at[2]));
}

void draw(Sight &sight, const SightLens &lens, const SightLens::Triangle &triangle, const int32_t *at,
		const Shares &shares, int number) {
	const float depths[3] = { lens.corner(at[0]).depth, lens.corner(at[1]).depth, lens.corner(at[2]).depth };
	const TriangleEdges edges(lens, triangle);
	for (int row = triangle.begin; row < triangle.end; row++) {
		int first, end;
		edges.columns(row, lens.columns(), first, end);
		if (first < end) {
			sight.reach(row, first, end);
		}
		for (int column = first; column < end; column++) {
			float share[3];
			shares.at(static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f, share);
			sight.put(row, column, share[0] * depths[0] + share[1] * depths[1] + share[2] * depths[2], number);
		}
	}
}

} // namespace

std::vector<float> seen_shares(const SeenMesh &mesh, const SightBox &box) {
	std::vector<glm::vec3> points(static_cast<size_t>(mesh.vertex_count));
	const SeenMesh turned = { points.data(), mesh.vertex_count, mesh.indices, mesh.index_count };
	std::vector<float> shares(points.size(), 0.0f);
	int count = 0;
	for (size_t view = 0; view < VIEWS; view++) {
		turn_to(view, mesh, points);
		SightLens lens(turned, turned_box(box), COLUMNS, ROWS);
		lens.set_view(0);
		Sight sight(lens.columns(), lens.rows());
		const std::vector<SightLens::Triangle> &triangles = lens.triangles();
		std::vector<Shares> planes(triangles.size());
		for (size_t i = 0; i < triangles.size(); i++) {
			const int32_t *at = mesh.indices + triangles[i].first;
			planes[i] = shares_of(lens, at);
			draw(sight, lens, triangles[i], at, planes[i], static_cast<int>(i));
		}
		sight.take([&](int number, float x, float y) {
			const int32_t *at = mesh.indices + triangles[static_cast<size_t>(number)].first;
			float share[3];
			planes[static_cast<size_t>(number)].at(x, y, share);
			for (int k = 0; k < 3; k++) {
				shares[static_cast<size_t>(at[k])] += share[k];
			}
			count++;
		});
	}
	for (float &share : shares) {
		share /= static_cast<float>(std::max(count, 1));
	}
	return shares;
}

} // namespace undergrowth

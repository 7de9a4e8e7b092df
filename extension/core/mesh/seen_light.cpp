// Colours of meshes from the side.

#include "mesh/sight_lens.hpp"

namespace undergrowth {

namespace {

constexpr int COLUMNS = 96; // Of a box.
constexpr int ROWS = 128;

/// What is nearest and farthest at each dot: nearest from the other side.
class Sight {
public:
	Sight(int p_columns, int rows) : columns(p_columns), dots(static_cast<size_t>(p_columns * rows)) {}

	void put(int row, int column, float depth, int triangle) {
		Dot &dot = dots[static_cast<size_t>(row * columns + column)];
		if (depth < dot.nearest) {
			dot.nearest = depth;
			dot.front = triangle;
		}
		if (depth > dot.farthest) {
			dot.farthest = depth;
			dot.back = triangle;
		}
	}
	/// Calls `look(triangle, x, y)` for what is seen from both sides, and forgets it.
	template <class Look> void take(const Look &look) {
		for (size_t i = 0; i < dots.size(); i++) {
			if (dots[i].front >= 0) {
				const float x = static_cast<float>(i % static_cast<size_t>(columns)) + 0.5f;
				const float y = static_cast<float>(i / static_cast<size_t>(columns)) + 0.5f;
				look(dots[i].front, x, y);
				look(dots[i].back, x, y);
				dots[i] = Dot();
			}
		}
	}

private:
	struct Dot {
		float nearest = 1e30f;
		float farthest = -1e30f;
		int front = -1; ///< Their first indices.
		int back = -1;
	};
	const int columns;
	std::vector<Dot> dots;
};

/// Shares of a triangle's corners at places in its plane.
struct Shares {
	float x, y; ///< Of the first corner, in dots.
	float b_x, b_y, c_x, c_y; ///< Of the others, a dot.

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

void draw(Sight &sight, const SightLens &lens, const int32_t *at, int triangle) {
	const SightLens::Corner &a = lens.corner(at[0]);
	const SightLens::Corner &b = lens.corner(at[1]);
	const SightLens::Corner &c = lens.corner(at[2]);
	const TriangleRows rows(a, b, c, lens.rows());
	if (rows.begin >= rows.end) {
		return;
	}
	const Shares shares(a, b, c);
	for (int row = rows.begin; row < rows.end; row++) {
		int first, end;
		rows.columns(row, lens.columns(), first, end);
		for (int column = first; column < end; column++) {
			float share[3];
			shares.at(static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f, share);
			sight.put(row, column, share[0] * a.depth + share[1] * b.depth + share[2] * c.depth, triangle);
		}
	}
}

} // namespace

std::vector<float> seen_shares(const SeenMesh &mesh, const SightBox &box) {
	SightLens lens(mesh, box, COLUMNS, ROWS);
	Sight sight(lens.columns(), lens.rows());
	std::vector<float> shares(static_cast<size_t>(mesh.vertex_count), 0.0f);
	int count = 0;
	for (size_t side = 0; side < OUTLINES; side++) {
		lens.look_from(side);
		for (int i = 0; i < mesh.index_count; i += 3) {
			draw(sight, lens, mesh.indices + i, i);
		}
		sight.take([&](int triangle, float x, float y) {
			const int32_t *at = mesh.indices + triangle;
			float share[3];
			Shares(lens.corner(at[0]), lens.corner(at[1]), lens.corner(at[2])).at(x, y, share);
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

float to_light(float component) {
	return component * (component * (component * 0.305306011f + 0.682171111f) + 0.012522878f);
}

float from_light(float light) {
	float component = std::sqrt(std::max(light, 0.0f));
	for (int i = 0; i < 4; i++) { // Newton's.
		const float slope = component * (component * 0.915918033f + 1.364342222f) + 0.012522878f;
		component = std::max(component - (to_light(component) - light) / slope, 0.0f);
	}
	return component;
}

} // namespace undergrowth

#include "placement/triangle_ground.hpp"

#include "base/bounded_whole.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace undergrowth {

namespace {

/// Triangles in the cells of a grid over the ground, so that a look-up tests only a few. (The engine's TriangleMesh was
/// 15 to 30 times slower for 100,000 plants.)
class TriangleGrid {
public:
	TriangleGrid(const glm::vec3 *triangles, int count);
	/// The highest or lowest point over (x, z). Returns false if no triangle is there.
	bool find(float x, float z, GroundChoice choice, float &height, glm::vec3 &normal) const;

private:
	const glm::vec3 *corners;
	float low_x = 0.0f, low_z = 0.0f;
	float cell = 1.0f;
	int columns = 1, rows = 1;
	std::vector<int> firsts; ///< Of each cell, and the end.
	std::vector<int> members; ///< Triangles by cell.

	int column_of(float x) const { return bounded_whole((x - low_x) / cell, 0, columns - 1); }
	int row_of(float z) const { return bounded_whole((z - low_z) / cell, 0, rows - 1); }
	template <class Act> void for_each_cell(int triangle, Act &&act) const;
};

constexpr int MAX_CELLS_PER_SIDE = 512;

TriangleGrid::TriangleGrid(const glm::vec3 *triangles, int count) : corners(triangles) {
	float high_x = 0.0f, high_z = 0.0f;
	for (int i = 0; i < 3 * count; i++) {
		low_x = i == 0 ? corners[i].x : std::min(low_x, corners[i].x);
		low_z = i == 0 ? corners[i].z : std::min(low_z, corners[i].z);
		high_x = i == 0 ? corners[i].x : std::max(high_x, corners[i].x);
		high_z = i == 0 ? corners[i].z : std::max(high_z, corners[i].z);
	}
	const float extent = std::max({ high_x - low_x, high_z - low_z, 1e-3f });
	const int side = std::clamp(static_cast<int>(std::sqrt(static_cast<float>(count))), 1, MAX_CELLS_PER_SIDE);
	cell = extent / static_cast<float>(side);
	columns = bounded_whole((high_x - low_x) / cell, 0, MAX_CELLS_PER_SIDE) + 1;
	rows = bounded_whole((high_z - low_z) / cell, 0, MAX_CELLS_PER_SIDE) + 1;
	firsts.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) + 1, 0);
	for (int i = 0; i < count; i++) {
		for_each_cell(i, [&](std::size_t at) { firsts[at + 1]++; });
	}
	for (size_t i = 1; i < firsts.size(); i++) {
		firsts[i] += firsts[i - 1];
	}
	members.resize(static_cast<std::size_t>(firsts.back()));
	std::vector<int> next(firsts.begin(), firsts.end() - 1);
	for (int i = 0; i < count; i++) {
		for_each_cell(i, [&](std::size_t at) { members[static_cast<std::size_t>(next[at]++)] = i; });
	}
}

template <class Act> void TriangleGrid::for_each_cell(int triangle, Act &&act) const {
	const glm::vec3 *t = corners + 3 * triangle;
	const int last_row = row_of(std::max({ t[0].z, t[1].z, t[2].z }));
	const int last_column = column_of(std::max({ t[0].x, t[1].x, t[2].x }));
	for (int row = row_of(std::min({ t[0].z, t[1].z, t[2].z })); row <= last_row; row++) {
		for (int column = column_of(std::min({ t[0].x, t[1].x, t[2].x })); column <= last_column; column++) {
			act(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column));
		}
	}
}

bool TriangleGrid::find(float x, float z, GroundChoice choice, float &height, glm::vec3 &normal) const {
	bool found = false;
	if (members.empty() || x < low_x || z < low_z || x > low_x + cell * static_cast<float>(columns) ||
			z > low_z + cell * static_cast<float>(rows)) {
		return false;
	}
	const std::size_t at = static_cast<std::size_t>(row_of(z)) * static_cast<std::size_t>(columns) +
			static_cast<std::size_t>(column_of(x));
	for (int i = firsts[at]; i < firsts[at + 1]; i++) {
		const glm::vec3 *t = corners + 3 * members[static_cast<std::size_t>(i)];
		const float ax = t[1].x - t[0].x, az = t[1].z - t[0].z;
		const float bx = t[2].x - t[0].x, bz = t[2].z - t[0].z;
		const float doubled = ax * bz - az * bx;
		const float px = x - t[0].x, pz = z - t[0].z;
		const float u = (px * bz - pz * bx) / doubled;
		const float v = (ax * pz - az * px) / doubled;
		if (!(u >= 0.0f && v >= 0.0f && u + v <= 1.0f)) {
			continue;
		}
		const float y = t[0].y + u * (t[1].y - t[0].y) + v * (t[2].y - t[0].y);
		if (!found || (choice == GroundChoice::highest ? y > height : y < height)) {
			found = true;
			height = y;
			const glm::vec3 across = glm::cross(t[1] - t[0], t[2] - t[0]);
			normal = across.y < 0.0f ? -across : across; // Up, for either winding of the triangle.
		}
	}
	return found;
}

} // namespace

void find_ground(const glm::vec3 *corners, int triangle_count, GroundChoice choice, const FieldPlants &plants,
		std::vector<float> &heights, std::vector<glm::vec3> &normals) {
	const TriangleGrid grid(corners, triangle_count);
	const auto count = static_cast<std::size_t>(plants.size());
	heights.assign(count, std::numeric_limits<float>::quiet_NaN());
	normals.assign(count, glm::vec3(0.0f, 1.0f, 0.0f));
	for (std::size_t i = 0; i < count; i++) {
		grid.find(plants.x[i], plants.z[i], choice, heights[i], normals[i]);
	}
}

} // namespace undergrowth

#include "climb/surface_grid.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float MIN_AREA = 1e-12f; // m², doubled and squared: smaller triangles are ignored.
constexpr float EDGES_PER_CELL = 2.0f;

/// Nearest point of a triangle (Ericson 2005, Real-Time Collision Detection, section 5.1.5).
glm::vec3 nearest_on(const glm::vec3 *corner, const glm::vec3 &p) {
	const glm::vec3 ab = corner[1] - corner[0];
	const glm::vec3 ac = corner[2] - corner[0];
	const glm::vec3 ap = p - corner[0];
	const float d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
	if (d1 <= 0.0f && d2 <= 0.0f) {
		return corner[0];
	}
	const glm::vec3 bp = p - corner[1];
	const float d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
	if (d3 >= 0.0f && d4 <= d3) {
		return corner[1];
	}
	const float vc = d1 * d4 - d3 * d2;
	if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f) {
		return corner[0] + ab * (d1 / (d1 - d3));
	}
	const glm::vec3 cp = p - corner[2];
	const float d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
	if (d6 >= 0.0f && d5 <= d6) {
		return corner[2];
	}
	const float vb = d5 * d2 - d1 * d6;
	if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f) {
		return corner[0] + ac * (d2 / (d2 - d6));
	}
	const float va = d3 * d6 - d5 * d4;
	if (va <= 0.0f && d4 - d3 >= 0.0f && d5 - d6 >= 0.0f) {
		return corner[1] + (corner[2] - corner[1]) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
	}
	const float over = 1.0f / (va + vb + vc);
	return corner[0] + ab * (vb * over) + ac * (vc * over);
}

/// Share of the way from `from` along `way` to the triangle, or a number above 1 (Möller and Trumbore 1997).
float share_to(const glm::vec3 *corner, const glm::vec3 &from, const glm::vec3 &way) {
	constexpr float NONE = 2.0f;
	const glm::vec3 ab = corner[1] - corner[0];
	const glm::vec3 ac = corner[2] - corner[0];
	const glm::vec3 side = glm::cross(way, ac);
	const float volume = glm::dot(ab, side);
	if (volume == 0.0f) {
		return NONE;
	}
	const glm::vec3 away = from - corner[0];
	const float u = glm::dot(away, side) / volume;
	const glm::vec3 other = glm::cross(away, ab);
	const float v = glm::dot(way, other) / volume;
	const float share = glm::dot(ac, other) / volume;
	const bool is_inside = u >= 0.0f && v >= 0.0f && u + v <= 1.0f && share >= 0.0f;
	return is_inside ? share : NONE;
}

glm::vec3 doubled_area(const glm::vec3 *corner) {
	return glm::cross(corner[2] - corner[0], corner[1] - corner[0]);
}

} // namespace

SurfaceGrid::SurfaceGrid(
		const ClimbSupport &support, const glm::vec3 &low, const glm::vec3 &high, float finest, float coarsest) :
		from_support(support) {
	glm::vec3 found_low(0.0f), found_high(0.0f);
	float edge = 0.0f;
	const std::vector<int> chosen = select(low, high, found_low, found_high, edge);
	found_low = glm::max(found_low, low);
	found_high = glm::min(found_high, high);
	cell = std::clamp(EDGES_PER_CELL * edge, finest, coarsest);
	fit(found_low, found_high);
	starts.assign(
			static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]) +
					1,
			0);
	for (const int triangle : chosen) {
		visit_cells(triangle, [&](int number) { starts[static_cast<std::size_t>(number) + 1]++; });
	}
	for (std::size_t i = 1; i < starts.size(); i++) {
		starts[i] += starts[i - 1];
	}
	entries.resize(static_cast<std::size_t>(starts.back()));
	std::vector<int> next(starts.begin(), starts.end() - 1);
	for (const int triangle : chosen) {
		visit_cells(triangle, [&](int number) {
			entries[static_cast<std::size_t>(next[static_cast<std::size_t>(number)]++)] = triangle;
		});
	}
}

/// Returns the triangles in the box, their bounds and the mean length of their edges.
std::vector<int> SurfaceGrid::select(
		const glm::vec3 &low, const glm::vec3 &high, glm::vec3 &found_low, glm::vec3 &found_high, float &edge) const {
	std::vector<int> chosen;
	double edges = 0.0;
	for (int i = 0; i < from_support.triangles(); i++) {
		const glm::vec3 *corner = corners_of(i);
		const glm::vec3 least = glm::min(corner[0], glm::min(corner[1], corner[2]));
		const glm::vec3 most = glm::max(corner[0], glm::max(corner[1], corner[2]));
		const bool is_apart = glm::any(glm::lessThan(most, low)) || glm::any(glm::greaterThan(least, high));
		const glm::vec3 area = doubled_area(corner);
		if (is_apart || !(glm::dot(area, area) > MIN_AREA)) {
			continue;
		}
		found_low = chosen.empty() ? least : glm::min(found_low, least);
		found_high = chosen.empty() ? most : glm::max(found_high, most);
		edges += std::sqrt(static_cast<double>(glm::length(area)));
		chosen.push_back(i);
	}
	edge = chosen.empty() ? 0.0f : static_cast<float>(edges / static_cast<double>(chosen.size()));
	return chosen;
}

void SurfaceGrid::fit(const glm::vec3 &low, const glm::vec3 &high) {
	for (;; cell *= 1.25f) {
		origin = low - glm::vec3(0.5f * cell);
		double cells = 1.0;
		for (int axis = 0; axis < 3; axis++) {
			const double along = static_cast<double>((high[axis] - low[axis]) / cell) + 2.0;
			size[axis] = static_cast<int>(std::min(std::max(along, 1.0), 1e6));
			cells *= static_cast<double>(size[axis]);
		}
		if (cells <= static_cast<double>(MAX_CELLS)) {
			return;
		}
	}
}

SurfaceGrid::Box SurfaceGrid::cells_around(const glm::vec3 &low, const glm::vec3 &high) const {
	Box box;
	for (int axis = 0; axis < 3; axis++) {
		const float last = static_cast<float>(size[axis] - 1);
		const float from = std::floor((low[axis] - origin[axis]) / cell);
		const float to = std::floor((high[axis] - origin[axis]) / cell);
		const bool is_apart = !(to >= 0.0f) || !(from <= last);
		box.low[axis] = is_apart ? 0 : static_cast<int>(std::max(from, 0.0f));
		box.high[axis] = is_apart ? -1 : static_cast<int>(std::min(to, last));
	}
	return box;
}

// Only the plane: a cell beside a corner of a triangle is listed too.
bool SurfaceGrid::touches(int triangle, int x, int y, int z) const {
	const glm::vec3 *corner = corners_of(triangle);
	const glm::vec3 middle = origin +
			cell * glm::vec3(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, static_cast<float>(z) + 0.5f);
	const glm::vec3 normal = doubled_area(corner);
	const float reach = 0.505f * cell * (std::fabs(normal.x) + std::fabs(normal.y) + std::fabs(normal.z));
	return std::fabs(glm::dot(normal, middle - corner[0])) <= reach;
}

template <class Visit> void SurfaceGrid::visit_cells(int triangle, const Visit &visit) const {
	const glm::vec3 *corner = corners_of(triangle);
	const Box box = cells_around(
			glm::min(corner[0], glm::min(corner[1], corner[2])), glm::max(corner[0], glm::max(corner[1], corner[2])));
	for (int z = box.low[2]; z <= box.high[2]; z++) {
		for (int y = box.low[1]; y <= box.high[1]; y++) {
			for (int x = box.low[0]; x <= box.high[0]; x++) {
				if (touches(triangle, x, y, z)) {
					visit(number_of(x, y, z));
				}
			}
		}
	}
}

template <class Visit> void SurfaceGrid::visit_triangles(const Box &box, const Visit &visit) const {
	for (int z = box.low[2]; z <= box.high[2]; z++) {
		for (int y = box.low[1]; y <= box.high[1]; y++) {
			for (int x = box.low[0]; x <= box.high[0]; x++) {
				const auto number = static_cast<std::size_t>(number_of(x, y, z));
				for (int i = starts[number]; i < starts[number + 1]; i++) {
					visit(entries[static_cast<std::size_t>(i)]);
				}
			}
		}
	}
}

SurfaceHit SurfaceGrid::nearest(const glm::vec3 &from, float reach) const {
	SurfaceHit found;
	float least = reach * reach;
	visit_triangles(cells_around(from - glm::vec3(reach), from + glm::vec3(reach)), [&](int triangle) {
		const glm::vec3 point = nearest_on(corners_of(triangle), from);
		const glm::vec3 way = point - from;
		const float square = glm::dot(way, way);
		if (square < least || (square == least && triangle < found.triangle)) {
			least = square;
			found.triangle = triangle;
			found.point = point;
		}
	});
	found.distance = std::sqrt(least);
	return found;
}

SurfaceHit SurfaceGrid::crossing(const glm::vec3 &from, const glm::vec3 &to) const {
	SurfaceHit found;
	float least = 1.0f;
	const glm::vec3 way = to - from;
	visit_triangles(cells_around(glm::min(from, to), glm::max(from, to)), [&](int triangle) {
		const float share = share_to(corners_of(triangle), from, way);
		if (share < least || (share == least && !found.is_valid())) {
			least = share;
			found.triangle = triangle;
		}
	});
	found.point = from + least * way;
	found.distance = least * glm::length(way);
	return found;
}

bool first_on_ray(const ClimbSupport &support, const glm::vec3 &from, const glm::vec3 &direction, glm::vec3 &place) {
	constexpr float FARTHEST = 1e4f; // Lengths of the direction.
	float least = 1.0f;
	for (int i = 0; i < support.triangles(); i++) {
		least = std::min(
				least, share_to(&support.corners[3 * static_cast<std::size_t>(i)], from, direction * FARTHEST));
	}
	place = from + direction * (FARTHEST * least);
	return least < 1.0f;
}

glm::vec3 SurfaceGrid::normal_of(int triangle) const {
	return glm::normalize(doubled_area(corners_of(triangle)));
}

} // namespace undergrowth

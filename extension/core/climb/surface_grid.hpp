#pragma once

#include "climb/climb_settings.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// A point on a triangle of a support.
struct SurfaceHit {
	int triangle = -1; ///< -1: none.
	glm::vec3 point = { 0.0f, 0.0f, 0.0f }; ///< m.
	float distance = 0.0f; ///< m from the query, or along its segment.

	bool is_valid() const { return triangle >= 0; }
};

/// Triangles in a uniform grid, for nearest points and crossings. Reads the support, which must outlive it. Any number
/// of threads may query it.
class SurfaceGrid {
public:
	/// Contains the triangles that touch the box from `low` to `high`. `finest` (m): the smallest useful cell,
	/// `coarsest` the largest.
	SurfaceGrid(const ClimbSupport &support, const glm::vec3 &low, const glm::vec3 &high, float finest, float coarsest);

	/// Returns the nearest point within `reach` metres.
	SurfaceHit nearest(const glm::vec3 &from, float reach) const;
	/// Returns the first triangle between two points. The segment should not be much longer than a cell.
	SurfaceHit crossing(const glm::vec3 &from, const glm::vec3 &to) const;
	/// Unit normal of a triangle by its winding (clockwise from the front).
	glm::vec3 normal_of(int triangle) const;
	bool is_empty() const { return entries.empty(); }

private:
	static constexpr int MAX_CELLS = 1 << 21;

	struct Box {
		int low[3], high[3];
	};

	const ClimbSupport &from_support;
	glm::vec3 origin = { 0.0f, 0.0f, 0.0f };
	float cell = 1.0f; ///< m.
	int size[3] = { 1, 1, 1 };
	std::vector<int> starts; ///< By cell: first of its entries, and the end.
	std::vector<int> entries; ///< Triangles.

	const glm::vec3 *corners_of(int triangle) const {
		return &from_support.corners[3 * static_cast<std::size_t>(triangle)];
	}
	std::vector<int> select(const glm::vec3 &low, const glm::vec3 &high, glm::vec3 &found_low, glm::vec3 &found_high,
			float &edge) const;
	void fit(const glm::vec3 &low, const glm::vec3 &high);
	Box cells_around(const glm::vec3 &low, const glm::vec3 &high) const;
	bool touches(int triangle, int x, int y, int z) const;
	int number_of(int x, int y, int z) const { return x + size[0] * (y + size[1] * z); }
	template <class Visit> void visit_cells(int triangle, const Visit &visit) const;
	template <class Visit> void visit_triangles(const Box &box, const Visit &visit) const;
};

/// Sets `place` to the first point of a support on a ray. Returns false if there is none. Tests all triangles.
bool first_on_ray(const ClimbSupport &support, const glm::vec3 &from, const glm::vec3 &direction, glm::vec3 &place);

} // namespace undergrowth

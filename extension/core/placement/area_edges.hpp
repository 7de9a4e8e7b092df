#pragma once

#include "placement/area.hpp"

#include <glm/vec2.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace undergrowth {

/// An edge of a polygon, directed towards larger z, so that two adjacent areas compute it equally.
struct AreaEdge {
	double low_x;
	double low_z;
	double high_x;
	double high_z;

	/// Within the edge's z.
	double x_at(double z) const { return low_x + (z - low_z) * (high_x - low_x) / (high_z - low_z); }

	/// True if the ray from the point towards +x crosses the edge.
	bool is_right_of(const glm::vec2 &point) const {
		const double z = point.y;
		return low_z <= z && z < high_z && static_cast<double>(point.x) < x_at(z);
	}

	/// Square of the distance (m²) of the point.
	double square_distance(const glm::vec2 &point) const {
		const double along_x = high_x - low_x;
		const double along_z = high_z - low_z;
		const double to_x = static_cast<double>(point.x) - low_x;
		const double to_z = static_cast<double>(point.y) - low_z;
		const double square = along_x * along_x + along_z * along_z;
		const double share = square > 0.0 ? (to_x * along_x + to_z * along_z) / square : 0.0;
		const double near = std::clamp(share, 0.0, 1.0);
		const double dx = to_x - near * along_x;
		const double dz = to_z - near * along_z;
		return dx * dx + dz * dz;
	}
};

template <class Visit> void for_each_edge(const Polygon &polygon, Visit visit) {
	for (std::size_t i = 0, last = polygon.size() - 1; i < polygon.size(); last = i++) {
		glm::dvec2 low = polygon[last];
		glm::dvec2 high = polygon[i];
		if (low.y > high.y) {
			std::swap(low, high);
		}
		visit(AreaEdge{ low.x, low.y, high.x, high.y });
	}
}

/// Appends the edges that meet the strip from `low` to `high` (m, z).
inline void add_edges_between(const Polygon &polygon, double low, double high, std::vector<AreaEdge> &to) {
	for_each_edge(polygon, [&](const AreaEdge &edge) {
		if (edge.high_z >= low && edge.low_z <= high) {
			to.push_back(edge);
		}
	});
}

} // namespace undergrowth

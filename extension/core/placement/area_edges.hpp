#pragma once

#include "placement/area.hpp"

#include <glm/vec2.hpp>

#include <utility>

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

} // namespace undergrowth

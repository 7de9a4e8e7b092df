#pragma once

#include "placement/area_edges.hpp"

#include <vector>

namespace undergrowth {

/// The edges of polygons within a distance of a strip along x.
class NearEdges {
public:
	/// Without edges.
	NearEdges() = default;
	/// The strip's range of z and the distance from it (m), > 0.
	NearEdges(double low_z, double high_z, double distance);

	void add(const Polygon &polygon);
	/// Distance (m) of a point of the strip from the nearest edge, at most `reach`.
	double distance_to(const glm::vec2 &point) const;

private:
	double low = 0.0; ///< m, z, of the strip with `reach` on both sides.
	double high = 0.0;
	double reach = 0.0; ///< m.
	std::vector<AreaEdge> edges;
};

} // namespace undergrowth

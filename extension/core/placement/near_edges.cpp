#include "placement/near_edges.hpp"

#include <cmath>

namespace undergrowth {

NearEdges::NearEdges(double low_z, double high_z, double distance) :
		low(low_z - distance), high(high_z + distance), reach(distance) {}

void NearEdges::add(const Polygon &polygon) {
	add_edges_between(polygon, low, high, edges);
}

double NearEdges::distance_to(const glm::vec2 &point) const {
	double square = reach * reach;
	for (const AreaEdge &edge : edges) {
		square = std::min(square, edge.square_distance(point));
	}
	return std::sqrt(square);
}

} // namespace undergrowth

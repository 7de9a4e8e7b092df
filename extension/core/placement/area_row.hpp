#pragma once

#include "placement/area_edges.hpp"
#include "placement/near_edges.hpp"

#include <cstddef>
#include <vector>

namespace undergrowth {

struct AreaSpan {
	double low;
	double high;
};

/// The edges of an area and its exclusions within a strip along x, so that a point test visits few edges.
struct AreaRow {
	double low; ///< m, z.
	double high;
	std::vector<AreaEdge> edges;
	std::vector<AreaEdge> exclusion_edges;
	std::vector<std::size_t> exclusion_ends; ///< End of each exclusion in `exclusion_edges`.
	NearEdges near; ///< None, unless the caller adds some.
	std::vector<AreaSpan> spans; ///< m, x: the spans contain the whole area. Unordered; may overlap.

	AreaRow(const Polygon &area, const std::vector<Polygon> &exclusions, double low_z, double high_z);

	/// For points of the strip: inside of the area and outside of all exclusions.
	bool holds(const glm::vec2 &point) const;

private:
	void find_spans();
};

/// Sorts spans and joins those that meet.
void join(std::vector<AreaSpan> &spans);

} // namespace undergrowth

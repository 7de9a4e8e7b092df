#pragma once

#include "stand/area_edges.hpp"

#include <cstddef>
#include <vector>

namespace undergrowth {

struct AreaSpan {
	double low;
	double high;
};

/// What matters of an area and its exclusions in a strip along x: with it a point costs a few edges only.
struct AreaRow {
	double low; ///< m, z.
	double high;
	std::vector<AreaEdge> edges;
	std::vector<AreaEdge> exclusion_edges;
	std::vector<std::size_t> exclusion_ends; ///< In `exclusion_edges`, one for each exclusion.
	std::vector<AreaSpan> spans; ///< m, x: nothing of the area is elsewhere. In no order, they may overlap.

	AreaRow(const Polygon &area, const std::vector<Polygon> &exclusions, double low_z, double high_z);

	/// For points of the strip: is_inside() of the area and of no exclusion.
	bool holds(const glm::vec2 &point) const;

private:
	void add_edges(const Polygon &polygon, std::vector<AreaEdge> &to) const;
	void find_spans();
};

/// Sorts spans and joins those that meet.
void join(std::vector<AreaSpan> &spans);

} // namespace undergrowth

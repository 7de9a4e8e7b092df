#include "placement/area_row.hpp"

#include <algorithm>

namespace undergrowth {

namespace {

bool is_inside_edges(const std::vector<AreaEdge> &edges, std::size_t begin, std::size_t end, const glm::vec2 &point) {
	bool inside = false;
	for (std::size_t i = begin; i < end; i++) {
		inside ^= edges[i].is_right_of(point);
	}
	return inside;
}

} // namespace

AreaRow::AreaRow(const Polygon &area, const std::vector<Polygon> &exclusions, double low_z, double high_z) :
		low(low_z), high(high_z) {
	add_edges_between(area, low, high, edges);
	for (const Polygon &exclusion : exclusions) {
		add_edges_between(exclusion, low, high, exclusion_edges);
		if (exclusion_edges.size() > (exclusion_ends.empty() ? 0 : exclusion_ends.back())) {
			exclusion_ends.push_back(exclusion_edges.size());
		}
	}
	find_spans();
}

/// Covers the area within the strip: the inside on its lower side, and all edges that cross the strip.
void AreaRow::find_spans() {
	std::vector<double> crossings;
	for (const AreaEdge &edge : edges) {
		const bool is_level = edge.low_z == edge.high_z;
		const double from = is_level ? edge.low_x : edge.x_at(std::max(low, edge.low_z));
		const double to = is_level ? edge.high_x : edge.x_at(std::min(high, edge.high_z));
		spans.push_back({ std::min(from, to), std::max(from, to) });
		if (edge.low_z <= low && low < edge.high_z) {
			crossings.push_back(from);
		}
	}
	std::sort(crossings.begin(), crossings.end());
	for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
		spans.push_back({ crossings[i], crossings[i + 1] });
	}
}

bool AreaRow::holds(const glm::vec2 &point) const {
	if (!is_inside_edges(edges, 0, edges.size(), point)) {
		return false;
	}
	std::size_t begin = 0;
	for (const std::size_t end : exclusion_ends) {
		if (is_inside_edges(exclusion_edges, begin, end, point)) {
			return false;
		}
		begin = end;
	}
	return true;
}

void join(std::vector<AreaSpan> &spans) {
	std::sort(spans.begin(), spans.end(), [](const AreaSpan &a, const AreaSpan &b) { return a.low < b.low; });
	std::size_t count = 0;
	for (const AreaSpan &span : spans) {
		if (count > 0 && span.low <= spans[count - 1].high) {
			spans[count - 1].high = std::max(spans[count - 1].high, span.high);
		} else {
			spans[count++] = span;
		}
	}
	spans.resize(count);
}

} // namespace undergrowth

#include "placement/area.hpp"

#include "placement/area_edges.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

namespace undergrowth {

namespace {

constexpr double MIN_AREA_SHARE = 1.0e-6;

bool is_finite(const glm::vec2 &point) {
	return std::isfinite(point.x) && std::isfinite(point.y);
}

bool is_near(const glm::vec2 &point) {
	return std::abs(point.x) <= FARTHEST_COORDINATE && std::abs(point.y) <= FARTHEST_COORDINATE;
}

/// Twice the area between the edges and any point: the sum of absolute values, which is 0 only for a line.
double spread_area(const Polygon &polygon) {
	double sum = 0.0;
	const glm::dvec2 origin = polygon[0];
	for (std::size_t i = 1; i + 1 < polygon.size(); i++) {
		const glm::dvec2 a = glm::dvec2(polygon[i]) - origin;
		const glm::dvec2 b = glm::dvec2(polygon[i + 1]) - origin;
		sum += std::abs(a.x * b.y - a.y * b.x);
	}
	return sum;
}

} // namespace

AreaFault find_area_fault(const Polygon &polygon) {
	if (polygon.size() < 3) {
		return AreaFault::too_few_points;
	}
	if (!std::all_of(polygon.begin(), polygon.end(), is_finite)) {
		return AreaFault::not_finite;
	}
	if (!std::all_of(polygon.begin(), polygon.end(), is_near)) {
		return AreaFault::too_far;
	}
	const AreaBox box = bounding_box(polygon);
	const double longer = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
	return spread_area(polygon) > MIN_AREA_SHARE * longer * longer ? AreaFault::none : AreaFault::no_area;
}

const char *describe(AreaFault fault) {
	switch (fault) {
		case AreaFault::none:
			return "The area is sound.";
		case AreaFault::too_few_points:
			return "The area has fewer than three points: add points.";
		case AreaFault::not_finite:
			return "A point of the area is not finite: set it again.";
		case AreaFault::too_far:
			return "A point of the area is more than 100 km from the field's origin: move the field instead.";
		case AreaFault::no_area:
			return "The area's points lie on a line: move them apart.";
	}
	return "";
}

Polygon rectangle(const glm::vec2 &size, const glm::vec2 &centre) {
	const glm::vec2 half = { 0.5f * std::abs(size.x), 0.5f * std::abs(size.y) };
	return { { centre.x - half.x, centre.y - half.y }, { centre.x + half.x, centre.y - half.y },
		{ centre.x + half.x, centre.y + half.y }, { centre.x - half.x, centre.y + half.y } };
}

bool is_inside(const Polygon &polygon, const glm::vec2 &point) {
	bool inside = false;
	for_each_edge(polygon, [&](const AreaEdge &edge) { inside ^= edge.is_right_of(point); });
	return inside;
}

double signed_area(const Polygon &polygon) {
	double twice = 0.0;
	for (std::size_t i = 0, last = polygon.size() - 1; i < polygon.size(); last = i++) {
		// Relative to the first point: far from the origin the products would lose digits.
		const glm::dvec2 a = glm::dvec2(polygon[last]) - glm::dvec2(polygon[0]);
		const glm::dvec2 b = glm::dvec2(polygon[i]) - glm::dvec2(polygon[0]);
		twice += a.x * b.y - a.y * b.x;
	}
	return 0.5 * twice;
}

double perimeter(const Polygon &polygon) {
	double sum = 0.0;
	for (std::size_t i = 0, last = polygon.size() - 1; i < polygon.size(); last = i++) {
		const glm::dvec2 way = glm::dvec2(polygon[i]) - glm::dvec2(polygon[last]);
		sum += std::sqrt(way.x * way.x + way.y * way.y);
	}
	return sum;
}

bool is_in_box(const AreaBox &box, const glm::vec2 &point) {
	return point.x >= box.low.x && point.x < box.high.x && point.y >= box.low.y && point.y < box.high.y;
}

AreaBox common_box(const AreaBox &one, const AreaBox &other) {
	return { { std::max(one.low.x, other.low.x), std::max(one.low.y, other.low.y) },
		{ std::min(one.high.x, other.high.x), std::min(one.high.y, other.high.y) } };
}

AreaBox changed_box(const Polygon &one, const Polygon &other) {
	const auto places = [](const AreaEdge &edge) {
		return std::make_tuple(edge.low_x, edge.low_z, edge.high_x, edge.high_z);
	};
	const auto is_before = [&](const AreaEdge &a, const AreaEdge &b) { return places(a) < places(b); };
	std::vector<AreaEdge> edges[2];
	for (int i = 0; i < 2; i++) {
		for_each_edge(i == 0 ? one : other, [&](const AreaEdge &edge) {
			if (edge.low_z < edge.high_z) { // Edges along x have no inner side.
				edges[i].push_back(edge);
			}
		});
		std::sort(edges[i].begin(), edges[i].end(), is_before);
	}
	std::vector<AreaEdge> differing;
	std::set_symmetric_difference(edges[0].begin(), edges[0].end(), edges[1].begin(), edges[1].end(),
			std::back_inserter(differing), is_before);
	Polygon ends;
	for (const AreaEdge &edge : differing) {
		ends.emplace_back(edge.low_x, edge.low_z);
		ends.emplace_back(edge.high_x, edge.high_z);
	}
	return ends.empty() ? AreaBox{ { 0.0f, 0.0f }, { -1.0f, -1.0f } } : bounding_box(ends);
}

AreaBox bounding_box(const Polygon &polygon) {
	if (polygon.empty()) {
		return {};
	}
	AreaBox box = { polygon[0], polygon[0] };
	for (const glm::vec2 &point : polygon) {
		box.low = { std::min(box.low.x, point.x), std::min(box.low.y, point.y) };
		box.high = { std::max(box.high.x, point.x), std::max(box.high.y, point.y) };
	}
	return box;
}

} // namespace undergrowth

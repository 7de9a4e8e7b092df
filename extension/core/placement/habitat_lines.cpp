#include "placement/habitat_lines.hpp"

#include "placement/area_edges.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

bool is_near(const AreaBox &some, const AreaBox &other, float reach) {
	return some.low.x - reach <= other.high.x && other.low.x <= some.high.x + reach &&
			some.low.y - reach <= other.high.y && other.low.y <= some.high.y + reach;
}

AreaEdge edge_between(const glm::dvec2 &from, const glm::dvec2 &to) {
	return { from.x, from.y, to.x, to.y };
}

} // namespace

AreaBox HabitatLines::box() const {
	Polygon all;
	for (const std::vector<Polygon> *some : { &open, &closed }) {
		for (const Polygon &line : *some) {
			all.insert(all.end(), line.begin(), line.end());
		}
	}
	return bounding_box(all);
}

HabitatLines HabitatLines::near(const AreaBox &box, float reach) const {
	HabitatLines found;
	for (const Polygon &line : open) {
		for (std::size_t i = 0; i + 1 < line.size(); i++) {
			const Polygon edge = { line[i], line[i + 1] };
			if (is_near(bounding_box(edge), box, reach)) {
				found.open.push_back(edge);
			}
		}
	}
	for (const Polygon &area : closed) {
		if (is_near(bounding_box(area), box, reach)) {
			found.closed.push_back(area);
		}
	}
	return found;
}

float HabitatLines::distance_to(const glm::vec2 &point, float reach) const {
	double square = static_cast<double>(reach) * static_cast<double>(reach);
	for (const Polygon &line : open) {
		for (std::size_t i = 0; i + 1 < line.size(); i++) {
			square = std::min(square, edge_between(line[i], line[i + 1]).square_distance(point));
		}
	}
	for (const Polygon &area : closed) {
		if (is_inside(area, point)) {
			return 0.0f;
		}
		for_each_edge(area, [&](const AreaEdge &edge) { square = std::min(square, edge.square_distance(point)); });
	}
	return static_cast<float>(std::sqrt(square));
}

} // namespace undergrowth

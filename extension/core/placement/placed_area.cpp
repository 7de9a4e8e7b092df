#include "placement/placed_area.hpp"

namespace undergrowth {

static constexpr float MARGIN = 0.01f; // m.

static void add_corners(const AreaBox &changed, float margin, Polygon &corners) {
	if (changed.low.x <= changed.high.x) {
		corners.push_back(changed.low - margin);
		corners.push_back(changed.high + margin);
	}
}

void PlacedArea::store_shapes(const PlacementRequest &request) {
	area = request.area;
	exclusions = request.exclusions;
}

bool PlacedArea::can_follow(const PlacementRequest &now) const {
	return !area.empty() && now.exclusions.size() == exclusions.size();
}

std::optional<AreaBox> PlacedArea::follow(const PlacementRequest &now) {
	const float margin = MARGIN + now.edge_falloff;
	Polygon corners; // Corners of boxes around differences.
	for (size_t i = 0; i < exclusions.size(); i++) {
		add_corners(changed_box(exclusions[i], now.exclusions[i]), margin, corners);
	}
	if (!now.map) {
		add_corners(changed_box(area, now.area), margin, corners);
	}
	store_shapes(now);
	return corners.empty() ? std::nullopt : std::optional(bounding_box(corners));
}

} // namespace undergrowth

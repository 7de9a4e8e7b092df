#include "card/card_axis.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace undergrowth {

namespace {

constexpr int SPANS = 16;
constexpr float STRAIGHT_FROM = 0.5f; // Offset: heads on the rest of a carrier have a straight axis.

} // namespace

CardAxis::CardAxis(const PlantForm &form, int carrier, float from) {
	const PlacedPart &part = form.placed[static_cast<size_t>(carrier)];
	const int spans = from > STRAIGHT_FROM ? 1 : SPANS;
	float along = 0.0f;
	for (int i = 0; i <= spans; i++) {
		const float offset = from + (1.0f - from) * static_cast<float>(i) / static_cast<float>(spans);
		const glm::vec3 point = form.point_of(part, offset);
		along += nodes.empty() ? 0.0f : glm::length(point - nodes.back().point);
		nodes.push_back({ point, form.axes_of(part, offset), along });
	}
	if (spans == 1 && !(nodes.back().along > 0.0f)) { // At the very tip.
		nodes.back().along = 1e-4f * part.length;
		nodes.back().point += nodes.back().axes.along * nodes.back().along;
	}
}

FlatPoint CardAxis::flatten(const glm::vec3 &point) const {
	float nearest = 0.0f;
	FlatPoint flat;
	for (size_t i = 0; i + 1 < nodes.size(); i++) {
		const Node &a = nodes[i];
		const Node &b = nodes[i + 1];
		const glm::vec3 way = b.point - a.point;
		const float square = glm::dot(way, way);
		float t = square > 0.0f ? glm::dot(point - a.point, way) / square : 0.0f;
		t = std::clamp(t, i == 0 ? -1e6f : 0.0f, i + 2 == nodes.size() ? 1e6f : 1.0f);
		const glm::vec3 offset = point - (a.point + way * t);
		const float distance = glm::dot(offset, offset);
		if (i == 0 || distance < nearest) {
			nearest = distance;
			const float share = std::clamp(t, 0.0f, 1.0f);
			const glm::vec3 across = a.axes.x * (1.0f - share) + b.axes.x * share;
			const glm::vec3 under = a.axes.outward * (1.0f - share) + b.axes.outward * share;
			flat.across = glm::dot(offset, across);
			flat.depth = -glm::dot(offset, under);
			flat.along = a.along + (b.along - a.along) * t;
		}
	}
	return flat;
}

} // namespace undergrowth

#include "mesh/cross_section.hpp"

#include "mesh/ear_clipping.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace undergrowth {

namespace {

glm::vec2 unit_or_zero(glm::dvec2 v) {
	const double length = glm::length(v);
	return length > 0.0 ? glm::vec2(v / length) : glm::vec2(0.0f);
}

} // namespace

glm::vec2 edge_normal(glm::vec2 from, glm::vec2 to) {
	const glm::dvec2 edge = glm::dvec2(to) - glm::dvec2(from);
	return unit_or_zero({ -edge.y, edge.x });
}

void ring_normals(const glm::vec2 *points, int count, glm::vec2 *normals) {
	glm::vec2 before = edge_normal(points[count - 1], points[0]);
	for (int i = 0; i < count; i++) {
		const glm::vec2 after = edge_normal(points[i], points[i + 1 < count ? i + 1 : 0]);
		const glm::vec2 sum = before + after;
		// The edges at a needle's point face in opposite directions; outward is the direction of the needle.
		const bool needle = glm::dot(sum, sum) < 1e-8f;
		normals[i] = needle ? glm::vec2(before.y, -before.x) : unit_or_zero(sum);
		before = after;
	}
}

CrossSection make_cross_section(const std::vector<glm::vec2> &ring) {
	CrossSection result;
	result.points = ring;
	result.normals.resize(ring.size());
	ring_normals(ring.data(), static_cast<int>(ring.size()), result.normals.data());
	result.reach.reserve(ring.size());
	for (size_t i = 0; i < ring.size(); i++) {
		result.reach.push_back(glm::dot(ring[i], result.normals[i]));
		result.radius = std::max(result.radius, glm::length(ring[i]));
	}
	result.cap = clip_ears(ring);
	return result;
}

} // namespace undergrowth

#include "field/bodies.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float TIP = 1.0f; // Share of the length.
constexpr float UPPER_STEM = 0.6f;
constexpr float LEAST_HEIGHT = 0.02f; // Of a pushed direction's y: where the ground stops it.
/// A push almost along the stem turns it no more than one this far from it would.
constexpr float LEAST_TANGENT = 0.3f;
constexpr float TINY = 1e-6f;

bool is_finite(const glm::vec3 &vector) {
	return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

glm::vec3 tangent_part(const glm::vec3 &vector, const glm::vec3 &direction) {
	return vector - glm::dot(vector, direction) * direction;
}

/// From the body's axis to the point; where that is no direction, away from the axis towards the root, else +x.
glm::vec3 way_out(const glm::vec3 &offset, const glm::vec3 &axis_point, const glm::vec3 &root) {
	if (glm::dot(offset, offset) > TINY * TINY) {
		return glm::normalize(offset);
	}
	const glm::vec3 aside = { root.x - axis_point.x, 0.0f, root.z - axis_point.z };
	return glm::dot(aside, aside) > TINY * TINY ? glm::normalize(aside) : glm::vec3(1.0f, 0.0f, 0.0f);
}

/// Turns `state` so that the point at `share` of the stem leaves the body; tells whether it was inside.
bool push_point(
		TipState &state, const glm::vec3 &root, float length, float share, float thickness, const FieldBody &body) {
	const float arm = share * length;
	const glm::vec3 point = root + arm * state.direction;
	const glm::vec3 axis_point = nearest_on_segment(body.from, body.to, point);
	const glm::vec3 offset = point - axis_point;
	const float depth = body.radius + thickness - glm::length(offset);
	if (depth <= 0.0f) {
		return false;
	}
	const glm::vec3 out = way_out(offset, axis_point, root);
	glm::vec3 along = tangent_part(out, state.direction);
	float size = glm::length(along);
	if (size < TINY) {
		along = tangent_part(way_out({}, axis_point, root + glm::vec3(TINY, 0.0f, 0.0f)), state.direction);
		size = std::max(glm::length(along), TINY);
	}
	along /= size;
	glm::vec3 moved = state.direction + along * (depth / (arm * std::max(size, LEAST_TANGENT)));
	moved.y = std::max(moved.y, LEAST_HEIGHT);
	state.direction = glm::normalize(moved);
	const float inward = glm::dot(arm * state.rate - body.velocity, along);
	if (inward < 0.0f) {
		state.rate -= along * (inward / arm);
	}
	state.rate = tangent_part(state.rate, state.direction);
	return true;
}

} // namespace

bool boxes_overlap(const MotionPage &page, const FieldBody &body) {
	const glm::vec3 low = glm::min(body.from, body.to) - body.radius;
	const glm::vec3 high = glm::max(body.from, body.to) + body.radius;
	return low.x <= page.high().x && high.x >= page.low().x && low.y <= page.high().y && high.y >= page.low().y &&
			low.z <= page.high().z && high.z >= page.low().z;
}

bool is_valid(const FieldBody &body) {
	return is_finite(body.from) && is_finite(body.to) && is_finite(body.velocity) && std::isfinite(body.radius) &&
			body.radius > 0.0f;
}

glm::vec3 nearest_on_segment(const glm::vec3 &from, const glm::vec3 &to, const glm::vec3 &point) {
	const glm::vec3 way = to - from;
	const float squared = glm::dot(way, way);
	const float part = squared > 0.0f ? std::clamp(glm::dot(point - from, way) / squared, 0.0f, 1.0f) : 0.0f;
	return from + part * way;
}

bool push_plant(TipState &state, const glm::vec3 &root, float length, float thickness, const FieldBody &body) {
	const bool inside = push_point(state, root, length, UPPER_STEM, 0.0f, body);
	return push_point(state, root, length, TIP, thickness, body) || inside;
}

int push_plants(MotionPage &page, const FieldBody &body) {
	if (!page.swings() || !is_valid(body)) {
		return 0;
	}
	const float thickness = std::max(page.collision_radius(), 0.0f);
	int touched = 0;
	for_each_in_reach(page, body, [&](int i) {
		TipState state = page.state(i);
		if (push_plant(state, page.root(i), page.length(i), thickness, body)) {
			page.set_state(i, state);
			touched++;
		}
	});
	return touched;
}

} // namespace undergrowth

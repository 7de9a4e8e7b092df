#include "motion/bodies.hpp"

#include "motion/part_bend.hpp"
#include "motion/stem_impulses.hpp"
#include "stem/stem_bones.hpp"
#include "stem/stem_points.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float TIP = 1.0f; // Share of the length.
constexpr float UPPER_STEM = 0.6f;
/// Minimum angle between push and stem; smaller angles count as this one.
constexpr float MIN_TANGENT = 0.3f;
constexpr float TINY = 1e-6f;
constexpr int PUSHED_PLACES = 8; // Of a stem that bends along its length, without its root.
constexpr int PUSHED_HALF = PUSHED_PLACES / 2;
constexpr float SLACK = 1.02f; // Of a length: quadrature finds the points of a stem.
constexpr int STEM_PARTS = 4; // Between the points of a stem that may touch a body.

bool is_finite(const glm::vec3 &vector) {
	return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

glm::vec3 tangent_part(const glm::vec3 &vector, const glm::vec3 &direction) {
	return vector - glm::dot(vector, direction) * direction;
}

/// Direction in which a point leaves a body.
struct Exit {
	float depth; ///< m, to the body's surface; below 0 outside of it.
	glm::vec3 out; ///< Unit.
};

/// Away from a centre line that the point is on: towards the root, or else +x.
glm::vec3 away_from_line(const glm::vec3 &point, const glm::vec3 &root) {
	const glm::vec3 aside = { root.x - point.x, 0.0f, root.z - point.z };
	return glm::dot(aside, aside) > TINY * TINY ? glm::normalize(aside) : glm::vec3(1.0f, 0.0f, 0.0f);
}

float share_of_turn(const glm::vec3 &out, const glm::vec3 &direction) {
	return std::max(glm::length(tangent_part(out, direction)), MIN_TANGENT);
}

/// Exit of a point in the core: through the face that turns the stem least.
Exit exit_of_core(const MovingBody &body, const glm::vec3 &point, const glm::vec3 &direction) {
	const glm::vec3 halves[] = { 0.5f * (body.to - body.from), body.half_width, body.half_depth };
	const glm::vec3 offset = point - 0.5f * (body.from + body.to);
	Exit best = { 0.0f, {} };
	float min = -1.0f;
	for (const glm::vec3 &half : halves) {
		const float size = glm::length(half);
		for (const float sign : { 1.0f, -1.0f }) {
			const glm::vec3 out = size > 0.0f ? half * (sign / size) : glm::vec3(0.0f);
			const float depth = body.radius + size - glm::dot(offset, out);
			const float turn = depth / share_of_turn(out, direction);
			if (size > 0.0f && (min < 0.0f || turn < min)) {
				min = turn;
				best = { depth, out };
			}
		}
	}
	return best;
}

Exit exit_of(const MovingBody &body, const glm::vec3 &point, const glm::vec3 &root, const glm::vec3 &direction) {
	const glm::vec3 offset = point - nearest_in_core(body, point);
	const float distance = glm::length(offset);
	if (distance > TINY) {
		return { body.radius - distance, glm::normalize(offset) };
	}
	const bool is_box = glm::dot(body.half_width, body.half_width) + glm::dot(body.half_depth, body.half_depth) > 0.0f;
	return is_box ? exit_of_core(body, point, direction) : Exit{ body.radius, away_from_line(point, root) };
}

/// Point nearest to `point` between moved - half and moved + half.
glm::vec3 nearest_along(const glm::vec3 &moved, const glm::vec3 &half, const glm::vec3 &point) {
	const float squared = glm::dot(half, half);
	const float part = squared > 0.0f ? std::clamp(glm::dot(point - moved, half) / squared, -1.0f, 1.0f) : 0.0f;
	return moved + part * half;
}

/// Turns `state` so that the point at `share` of the stem leaves the body. Returns true if it was inside.
bool push_point(
		TipState &state, const glm::vec3 &root, float length, float share, float thickness, const MovingBody &body) {
	const float arm = share * length;
	const glm::vec3 point = root + arm * state.direction;
	const Exit exit = exit_of(body, point, root, state.direction);
	const float depth = exit.depth + thickness;
	if (depth <= 0.0f) {
		return false;
	}
	glm::vec3 along = tangent_part(exit.out, state.direction);
	float size = glm::length(along);
	if (size < TINY) {
		along = tangent_part(away_from_line(point, root), state.direction);
		size = std::max(glm::length(along), TINY);
	}
	along /= size;
	glm::vec3 moved = state.direction + along * (depth / (arm * std::max(size, MIN_TANGENT)));
	moved.y = std::max(moved.y, MIN_PUSHED_HEIGHT);
	state.direction = glm::normalize(moved);
	const float inward = glm::dot(arm * state.rate - body.velocity, along);
	if (inward < 0.0f) {
		state.rate -= along * (inward / arm);
	}
	state.rate = tangent_part(state.rate, state.direction);
	return true;
}

/// Pushes one point of a stem, as push_point() pushes a straight plant.
bool push_place(const StemConstants &stem, StemState &state, const glm::vec2 &rest, const glm::vec3 &root, float length,
		float x, float thickness, const MovingBody &body) {
	const StemPlace place = stem_place(stem, state.place, x);
	const glm::vec3 point = root + length * turned(place.centre, rest);
	const glm::vec3 direction = turned(from_stereographic(place.bend), rest);
	const Exit exit = exit_of(body, point, root, direction);
	const float depth = exit.depth + thickness;
	if (depth <= 0.0f) {
		return false;
	}
	glm::vec3 along = tangent_part(exit.out, direction);
	float size = glm::length(along);
	if (size < TINY) {
		along = tangent_part(away_from_line(point, root), direction);
		size = std::max(glm::length(along), TINY);
	}
	along = turned(along / size, -rest);
	const float scale = stem.length / length;
	push_stem(stem, state, x, along * (depth / std::max(size, MIN_TANGENT)), scale);
	const float inward = glm::dot(stem_velocity(stem, state, x, scale) - turned(body.velocity, -rest), along);
	if (inward < 0.0f) {
		apply_stem_impulse(stem, state, x, along * (-inward * stem_mass(stem, x)), scale);
	}
	return true;
}

/// Distance of a point from the body's core (m).
float distance_to_core(const MovingBody &body, const glm::vec3 &point) {
	return glm::distance(nearest_in_core(body, point), point);
}

/// The first point of a stem that is in the body; above PUSHED_PLACES if none is. With the distances a and b of its
/// ends from the body, a piece of the stem is at least (a + b - length) / 2 away.
int first_place_inside(const StemConstants &stem, const StemState &state, const glm::vec2 &rest, const glm::vec3 &root,
		float length, float thickness, const MovingBody &body) {
	glm::vec3 points[PUSHED_PLACES];
	stem_points(stem, state.place, 2, 1, 2, points);
	const float half = 0.5f * SLACK * length;
	const float reach = 2.0f * (body.radius + thickness) + half;
	const float at_root = distance_to_core(body, root);
	const float at_middle = distance_to_core(body, root + length * turned(points[0], rest));
	const float at_tip = distance_to_core(body, root + length * turned(points[1], rest));
	const bool may_be_low = at_root + at_middle <= reach;
	const bool may_be_high = at_middle + at_tip <= reach;
	if (!may_be_low && !may_be_high) {
		return PUSHED_PLACES + 1;
	}
	const int first = may_be_low ? 1 : PUSHED_HALF;
	const int last = may_be_high ? PUSHED_PLACES : PUSHED_HALF;
	stem_points(stem, state.place, PUSHED_PLACES, first, last, points);
	for (int part = first; part <= last; part++) {
		const float own = part == PUSHED_PLACES ? thickness : 0.0f;
		if (distance_to_core(body, root + length * turned(points[part - first], rest)) < body.radius + own) {
			return part;
		}
	}
	return PUSHED_PLACES + 1;
}

/// The body in the axes of the page's directions.
MovingBody turned_inward(const MovingBody &body, const PageFrame &frame) {
	MovingBody turned = body;
	for (glm::vec3 MovingBody::*vector : { &MovingBody::from, &MovingBody::to, &MovingBody::velocity,
				 &MovingBody::half_width, &MovingBody::half_depth }) {
		turned.*vector = frame.inward(body.*vector);
	}
	return turned;
}

glm::vec3 lesser_velocity(const MovingBody &body, const glm::vec3 &root_velocity) {
	const glm::vec3 seen = body.velocity - root_velocity;
	return glm::dot(seen, seen) < glm::dot(body.velocity, body.velocity) ? seen : body.velocity;
}

} // namespace

BodyBox box_of(const MovingBody &body) {
	const glm::vec3 reach = glm::abs(body.half_width) + glm::abs(body.half_depth) + body.radius;
	return { glm::min(body.from, body.to) - reach, glm::max(body.from, body.to) + reach };
}

bool boxes_overlap(const MotionPage &page, const MovingBody &body) {
	const auto [low, high] = box_of(body);
	return low.x <= page.high().x && high.x >= page.low().x && low.y <= page.high().y && high.y >= page.low().y &&
			low.z <= page.high().z && high.z >= page.low().z;
}

bool is_valid(const MovingBody &body) {
	return is_finite(body.from) && is_finite(body.to) && is_finite(body.velocity) && is_finite(body.half_width) &&
			is_finite(body.half_depth) && std::isfinite(body.radius) && body.radius > 0.0f;
}

glm::vec3 nearest_in_core(const MovingBody &body, const glm::vec3 &point) {
	const glm::vec3 on_line = nearest_on_segment(body.from, body.to, point);
	return nearest_along(nearest_along(on_line, body.half_width, point), body.half_depth, point);
}

glm::vec3 nearest_on_segment(const glm::vec3 &from, const glm::vec3 &to, const glm::vec3 &point) {
	const glm::vec3 way = to - from;
	const float squared = glm::dot(way, way);
	const float part = squared > 0.0f ? std::clamp(glm::dot(point - from, way) / squared, 0.0f, 1.0f) : 0.0f;
	return from + part * way;
}

bool is_root_in_reach(const MovingBody &body, const glm::vec3 &root, float reach) {
	return distance_to_core(body, root) <= body.radius + SLACK * reach;
}

// Most rows are far away. A first pass without branches, which compilers vectorize, finds the groups with rows in
// reach.
int rows_in_reach(const MotionPage &page, const BodyReach &reach, int begin, int end, int *indices) {
	constexpr int GROUP = 16;
	const float middle_x = 0.5f * (reach.low_x + reach.high_x);
	const float middle_z = 0.5f * (reach.low_z + reach.high_z);
	const float half_x = reach.high_x - middle_x;
	const float half_z = reach.high_z - middle_z;
	const float *x = page.roots_x();
	const float *z = page.roots_z();
	const float *lengths = page.lengths();
	int count = 0;
	for (int first = begin; first < end; first += GROUP) {
		float beyond[GROUP]; // Distance (m) from the body's box along the farther axis, minus the plant's length.
		for (int i = 0; i < GROUP; i++) { // Columns have room for whole groups.
			const float beyond_x = std::fabs(x[first + i] - middle_x) - half_x;
			const float beyond_z = std::fabs(z[first + i] - middle_z) - half_z;
			beyond[i] = (beyond_x > beyond_z ? beyond_x : beyond_z) - lengths[first + i];
		}
		int is_any_near = 0;
		for (int i = 0; i < GROUP; i++) {
			is_any_near |= beyond[i] <= 0.0f ? 1 : 0;
		}
		for (int i = first; is_any_near && i < std::min(first + GROUP, end); i++) {
			if (beyond[i - first] <= 0.0f && lengths[i] > 0.0f) {
				indices[count++] = i;
			}
		}
	}
	return count;
}

bool push_plant(TipState &state, const glm::vec3 &root, float length, float thickness, const MovingBody &body) {
	const bool inside = push_point(state, root, length, UPPER_STEM, 0.0f, body);
	return push_point(state, root, length, TIP, thickness, body) || inside;
}

bool push_plant(const StemConstants &stem, StemState &state, const glm::vec2 &rest, const glm::vec3 &root, float length,
		float thickness, const MovingBody &body) {
	bool inside = false;
	for (int part = first_place_inside(stem, state, rest, root, length, thickness, body); part <= PUSHED_PLACES;
			part++) {
		const float x = static_cast<float>(part) / PUSHED_PLACES;
		inside |= push_place(stem, state, rest, root, length, x, part == PUSHED_PLACES ? thickness : 0.0f, body);
	}
	return inside;
}

bool touches_plant(const MotionPage &page, int index, const MovingBody &body, float margin, const PageFrame &frame) {
	const float thickness = std::max(page.collision_radius(), 0.0f);
	const glm::vec3 root = page.root(index);
	for (int part = 0; part <= STEM_PARTS; part++) {
		const float share = static_cast<float>(part) / static_cast<float>(STEM_PARTS);
		const glm::vec3 point = root + frame.outward(page.arm(index, share));
		const float distance = glm::distance(nearest_in_core(body, point), point);
		if (distance <= body.radius + margin + (part == STEM_PARTS ? thickness : 0.0f)) {
			return true;
		}
	}
	return false;
}

bool touches_plants(const MotionPage &page, const MovingBody &body, float margin) {
	MovingBody reach = body;
	reach.radius += margin;
	bool touches = false;
	for_each_in_reach(page, reach, [&](int i) { touches = touches || touches_plant(page, i, body, margin); });
	return touches;
}

int push_plants(MotionPage &page, const MovingBody &body, const PageFrame &frame) {
	if (!page.swings() || !is_valid(body) || !boxes_overlap(page, body)) {
		return 0;
	}
	const float thickness = std::max(page.collision_radius(), 0.0f);
	MovingBody seen = turned_inward(body, frame);
	int touched = 0;
	for_each_in_reach(page, body, [&](int i) {
		seen.velocity = frame.inward(frame.velocities ? lesser_velocity(body, frame.velocities[i]) : body.velocity);
		if (page.law() == Law::stem) {
			StemState stem = page.stem(i);
			if (push_plant(page.stem_constants(), stem, page.rest_bend(i), frame.inward(page.root(i)), page.length(i),
						thickness, seen)) {
				page.set_stem(i, stem);
				touched++;
			}
			return;
		}
		TipState state = page.state(i);
		if (push_plant(state, frame.inward(page.root(i)), page.length(i), thickness, seen)) {
			page.set_state(i, state);
			touched++;
		}
	});
	return touched;
}

} // namespace undergrowth

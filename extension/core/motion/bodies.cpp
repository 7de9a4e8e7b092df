#include "motion/bodies.hpp"

#include "motion/kernel_tables.hpp"
#include "motion/part_bend.hpp"
#include "motion/stem_impulses.hpp"
#include "stem/stem_bones.hpp"

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

/// m/s, of the body's surface at the exit.
glm::vec3 surface_velocity(const MovingBody &body, const Exit &exit) {
	return body.velocity + body.growth * exit.out;
}

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
	const float inward = glm::dot(arm * state.rate - surface_velocity(body, exit), along);
	if (inward < 0.0f) {
		state.rate -= along * (inward / arm);
	}
	state.rate = tangent_part(state.rate, state.direction);
	return true;
}

/// Pushes one point of a stem, the one at x, as push_point() pushes a straight plant.
bool push_place(const StemConstants &stem, const StemPoint &pushed, StemState &state, const glm::vec2 &rest,
		const glm::vec3 &root, float length, float x, float thickness, const MovingBody &body) {
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
	push_stem(stem, state, pushed, place.bend, along * (depth / std::max(size, MIN_TANGENT)), scale);
	const glm::vec2 bend = stem_bend(stem, state.place, x);
	const glm::vec3 velocity = stem_velocity(stem, state, pushed, bend, scale);
	const float inward = glm::dot(velocity - turned(surface_velocity(body, exit), -rest), along);
	if (inward < 0.0f) {
		apply_stem_impulse(stem, state, pushed, bend, along * (-inward * pushed.mass), scale);
	}
	return true;
}

/// Distance of a point from the body's core (m).
float distance_to_core(const MovingBody &body, const glm::vec3 &point) {
	return glm::distance(nearest_in_core(body, point), point);
}

/// Bends of a species' stems at the places that bodies push.
StemCurve curve_of(const StemConstants &stem) {
	static constexpr float AT[] = { 0.11270167f, 0.5f, 0.88729833f }; // Quadrature of three points, from 0 to 1.
	static constexpr float WEIGHT[] = { 0.27777778f, 0.44444444f, 0.27777778f };
	StemCurve curve = {};
	for (int k = 0; k < stem.modes; k++) {
		curve.tip_slope[k] = stem.mode[k].tip_slope;
	}
	for (int g = 0; g < 3; g++) {
		float x[StemCurve::PLACES];
		for (int place = 0; place < StemCurve::PLACES; place++) {
			const float end = static_cast<float>(place + 1) / StemCurve::PLACES;
			x[place] = AT[g] * end;
			curve.weight[g][place] = WEIGHT[g] * end;
		}
		for (int term = 0; term < 4; term++) {
			const bool is_none = term >= stem.modes && term < MAX_STEM_MODES;
			float *values = curve.value[g][term];
			for (int j = STEM_SHAPE_TERMS - 1; j >= 0 && !is_none; j--) {
				for (int place = 0; place < StemCurve::PLACES; place++) { // The inner loop, so that it is vectorised.
					values[place] = (values[place] + stem.shape[j][term]) * x[place];
				}
			}
		}
	}
	return curve;
}

void put_vector(const glm::vec3 &vector, float *to) {
	to[0] = vector.x;
	to[1] = vector.y;
	to[2] = vector.z;
}

float inverse_square(const glm::vec3 &vector) {
	const float square = glm::dot(vector, vector);
	return square > 0.0f ? 1.0f / square : 0.0f;
}

/// Stems of one species that a body pushes. The arguments must outlive the object.
class StemPush {
public:
	/// `body`: in the axes of the page's directions.
	StemPush(const StemConstants &p_stem, float p_thickness, const MovingBody &p_body) :
			stem(p_stem),
			thickness(p_thickness),
			body(p_body),
			set(kernels(best_simd_level())),
			curve(curve_of(p_stem)),
			ways{ body.to - body.from, body.half_width, body.half_depth } {
		put_vector(body.from, core.from);
		put_vector(ways[0], core.way);
		core.inverse = inverse_square(ways[0]);
		for (int k = 0; k < 2; k++) {
			put_vector(ways[k + 1], core.half[k]);
			core.half_inverse[k] = inverse_square(ways[k + 1]);
		}
		core.is_box = core.half_inverse[0] + core.half_inverse[1] > 0.0f;
		for (int part = 1; part <= PUSHED_PLACES; part++) {
			points[part - 1] = stem_point(stem, share_of(part));
		}
	}

	/// Writes for each stem which of its halves may be in the body.
	void find_near(const NearStems &stems, int count, int32_t *halves) const {
		set.find_near_stems(curve, core, 2.0f * (body.radius + thickness), stems, count, halves);
	}

	/// Returns true if a place of the given halves was in the body.
	bool push(StemState &state, const glm::vec2 &rest, const glm::vec3 &root, float length, int32_t halves) const {
		BodyCore turned_core = core;
		put_vector(turned(body.from - root, -rest), turned_core.from);
		put_vector(turned(ways[0], -rest), turned_core.way);
		for (int k = 0; core.is_box && k < 2; k++) {
			put_vector(turned(ways[k + 1], -rest), turned_core.half[k]);
		}
		const int first = (halves & LOWER) != 0 ? 1 : PUSHED_HALF;
		const int last = (halves & UPPER) != 0 ? PUSHED_PLACES : PUSHED_HALF;
		const float slack = slack_of(root, length);
		bool is_inside = false;
		uint32_t near = near_places(turned_core, state, length, slack);
		for (int part = first; part <= (is_inside ? PUSHED_PLACES : last) && near >> part != 0u; part++) {
			if ((near >> part & 1u) != 0u &&
					push_place(stem, points[part - 1], state, rest, root, length, share_of(part),
							part == PUSHED_PLACES ? thickness : 0.0f, body)) {
				is_inside = true;
				near = part < PUSHED_PLACES ? near_places(turned_core, state, length, slack) : 0u;
			}
		}
		return is_inside;
	}

	/// m: covers the rounding of kernels and of positions far from the origin.
	static float slack_of(const glm::vec3 &root, float length) {
		return 2e-3f * length + 1e-6f * (std::fabs(root.x) + std::fabs(root.y) + std::fabs(root.z));
	}

private:
	enum : int32_t { LOWER = 1, UPPER = 2 };

	const StemConstants &stem;
	float thickness;
	const MovingBody &body;
	const KernelSet &set;
	StemCurve curve;
	StemPoint points[PUSHED_PLACES];
	glm::vec3 ways[3];
	BodyCore core;

	static float share_of(int part) { return static_cast<float>(part) / PUSHED_PLACES; }

	/// A bit for each place that may be in the body, 1 to PUSHED_PLACES.
	uint32_t near_places(const BodyCore &turned_core, const StemState &state, float length, float slack) const {
		const bool has_two = stem.modes == 2;
		const float x[] = { state.place[0].x, has_two ? state.place[1].x : 0.0f };
		const float z[] = { state.place[0].y, has_two ? state.place[1].y : 0.0f };
		float squares[StemCurve::PLACES];
		set.measure_stem(curve, turned_core, x, z, length, squares);
		uint32_t near = 0;
		for (int place = 0; place < StemCurve::PLACES; place++) {
			const float reach = body.radius + slack + (place == StemCurve::PLACES - 1 ? thickness : 0.0f);
			near |= (squares[place] < reach * reach ? 2u : 0u) << place;
		}
		return near;
	}
};

static_assert(PUSHED_PLACES == StemCurve::PLACES && REACH_ROWS == NearStems::MAX, "as many as kernels examine");

void gather(const float *column, const int *indices, int count, float *to) {
	for (int i = 0; i < count; i++) {
		to[i] = column ? column[indices[i]] : 0.0f;
	}
}

/// Repeats the last index up to the next whole group: kernels are slow at what remains beside whole groups. Returns the
/// number with repeats.
int fill_group(int *indices, int count) {
	constexpr int GROUP = 8;
	static_assert(REACH_ROWS % GROUP == 0, "has room");
	const int whole = (count + GROUP - 1) / GROUP * GROUP;
	std::fill(indices + count, indices + whole, indices[count - 1]);
	return whole;
}

/// Columns of the plants of a page with these indices. `rows`: all of the page.
void gather_stems(const MotionPage &page, const StemPage &rows, const PageFrame &frame, const int *indices, int count,
		NearStems &stems) {
	for (int k = 0; k < MAX_STEM_MODES; k++) {
		gather(rows.x[k], indices, count, stems.x[k]);
		gather(rows.z[k], indices, count, stems.z[k]);
	}
	gather(rows.rest_x, indices, count, stems.rest_x);
	gather(rows.rest_z, indices, count, stems.rest_z);
	gather(page.lengths(), indices, count, stems.length);
	gather(page.roots_x(), indices, count, stems.root_x);
	gather(page.roots_y(), indices, count, stems.root_y);
	gather(page.roots_z(), indices, count, stems.root_z);
	for (int i = 0; i < count; i++) {
		const glm::vec3 root = frame.inward({ stems.root_x[i], stems.root_y[i], stems.root_z[i] });
		stems.root_x[i] = root.x;
		stems.root_y[i] = root.y;
		stems.root_z[i] = root.z;
		stems.half[i] = 0.5f * SLACK * stems.length[i] + 2.0f * StemPush::slack_of(root, stems.length[i]);
	}
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
	return is_finite(body.from) && is_finite(body.to) && is_finite(body.velocity) && std::isfinite(body.growth) &&
			is_finite(body.half_width) && is_finite(body.half_depth) && std::isfinite(body.radius) &&
			body.radius > 0.0f;
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
			indices[count] = i; // Without a branch: about half of them are in reach.
			count += static_cast<int>(beyond[i - first] <= 0.0f) & static_cast<int>(lengths[i] > 0.0f);
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
	return StemPush(stem, thickness, body).push(state, rest, root, length, ~0);
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

void make_room_for_lasting_bends(MotionPage &page, const std::vector<MovingBody> &bodies) {
	page.make_room_for_lasting_bends(page.trampling().share > 0.0f &&
			std::any_of(bodies.begin(), bodies.end(),
					[&page](const MovingBody &body) { return boxes_overlap(page, body); }));
}

/// Pushes the stems of a page.
static int push_stems(MotionPage &page, const MovingBody &body, const PageFrame &frame) {
	const float thickness = std::max(page.collision_radius(), 0.0f);
	MovingBody seen = turned_inward(body, frame);
	const StemPush push(page.stem_constants(), thickness, seen);
	const StemPage rows = page.stem_page(0);
	const float lasting = page.trampling().approach(page.step_length());
	int touched = 0;
	for_each_block_in_reach(page, body, [&](int *indices, int count) {
		NearStems stems;
		int32_t halves[NearStems::MAX];
		MovedStems pushed;
		const int whole = fill_group(indices, count);
		gather_stems(page, rows, frame, indices, whole, stems);
		push.find_near(stems, whole, halves);
		for (int i = 0; i < count; i++) {
			if (halves[i] == 0) {
				continue;
			}
			if (frame.velocities) {
				seen.velocity = frame.inward(lesser_velocity(body, frame.velocities[indices[i]]));
			}
			StemState state = page.stem(indices[i]);
			const glm::vec3 root = { stems.root_x[i], stems.root_y[i], stems.root_z[i] };
			if (push.push(state, { stems.rest_x[i], stems.rest_z[i] }, root, stems.length[i], halves[i])) {
				pushed.add(indices[i], state);
				page.let_last(indices[i], tip_bend(page.stem_constants(), state), lasting);
			}
		}
		page.set_stems(pushed);
		touched += pushed.count;
	});
	return touched;
}

int push_plants(MotionPage &page, const MovingBody &body, const PageFrame &frame) {
	if (!page.swings() || !boxes_overlap(page, body) || !is_valid(body)) {
		return 0;
	}
	if (page.law() == Law::stem) {
		return push_stems(page, body, frame);
	}
	const float thickness = std::max(page.collision_radius(), 0.0f);
	MovingBody seen = turned_inward(body, frame);
	int touched = 0;
	for_each_in_reach(page, body, [&](int i) {
		seen.velocity = frame.inward(frame.velocities ? lesser_velocity(body, frame.velocities[i]) : body.velocity);
		TipState state = page.state(i);
		if (push_plant(state, frame.inward(page.root(i)), page.length(i), thickness, seen)) {
			page.set_state(i, state);
			touched++;
		}
	});
	return touched;
}

} // namespace undergrowth

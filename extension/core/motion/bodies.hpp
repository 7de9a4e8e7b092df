#pragma once

#include "motion/motion_page.hpp"

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <vector>

namespace undergrowth {

/// Minimum y of the direction of a pushed plant: the ground stops it.
inline constexpr float MIN_PUSHED_HEIGHT = 0.02f;

/// A moving capsule, sphere or box that pushes plants out of its way: all points nearer than `radius` to its core. A
/// capsule's core is a segment, a sphere's is a segment whose ends are the same point, and that of a box whose edges
/// are rounded by `radius` is a box.
struct MovingBody {
	glm::vec3 from = { 0.0f, 0.0f, 0.0f }; ///< m, field axes: the ends of the core's middle line.
	glm::vec3 to = { 0.0f, 0.0f, 0.0f };
	float radius = 0.5f; ///< m, > 0.
	glm::vec3 velocity = { 0.0f, 0.0f, 0.0f }; ///< m/s.
	float growth = 0.0f; ///< m/s, of the radius.
	/// m, of a box only: half of its core's other two edges, at right angles to the middle line and to each other.
	glm::vec3 half_width = { 0.0f, 0.0f, 0.0f };
	glm::vec3 half_depth = { 0.0f, 0.0f, 0.0f };
};

/// Corners of the box along the axes that holds a body (m).
struct BodyBox {
	glm::vec3 low;
	glm::vec3 high;
};
BodyBox box_of(const MovingBody &body);

/// True if all numbers are finite and the radius is above 0.
bool is_valid(const MovingBody &body);

/// Axes and velocities of a page of single plants; pages of a field have neither.
struct PageFrame {
	const glm::mat3 *axes = nullptr; ///< Axes of the page's directions in those of its roots; null: identity.
	const glm::vec3 *velocities = nullptr; ///< m/s, of the roots, MotionPage::size() values; null: at rest.

	/// From the axes of the page's directions to those of its roots.
	glm::vec3 outward(const glm::vec3 &vector) const { return axes ? *axes * vector : vector; }
	/// The way back.
	glm::vec3 inward(const glm::vec3 &vector) const { return axes ? vector * *axes : vector; }
};

/// Turns one plant of `length` (m) out of the body as push_plants() does. Returns true if it was inside.
bool push_plant(TipState &state, const glm::vec3 &root, float length, float thickness, const MovingBody &body);

/// The same for a stem that bends along its length: at eight points from the ground up, so that a body pushes where it
/// touches. `rest`: the bend of its rest.
bool push_plant(const StemConstants &stem, StemState &state, const glm::vec2 &rest, const glm::vec3 &root, float length,
		float thickness, const MovingBody &body);

/// Calls visit(index) for each plant of a page that the body may touch, in ascending order. Skips removed plants.
/// `body`: valid.
template <class Visit> void for_each_in_reach(const MotionPage &page, const MovingBody &body, const Visit &visit);

/// Pushes the plants of a swinging page out of a body: the tip, which is a sphere of the collision radius, and a point
/// of the upper stem, along their spheres, by as much as they are inside. The contact is inelastic:
/// it removes the velocity towards the body. A root that moves past a body, or together with it, does not push by that:
/// the smaller of the body's velocity and its velocity relative to the root counts. Returns the number of touched
/// plants.
int push_plants(MotionPage &page, const MovingBody &body, const PageFrame &frame = {});

/// Makes room on a page for the lasting bends that these bodies leave in the next step (MotionPage), if their species
/// has Trampling. Call it before the step: pushes allocate nothing.
void make_room_for_lasting_bends(MotionPage &page, const std::vector<MovingBody> &bodies);

/// True if a plant of the page is within `margin` (m) of a valid body, its tip thickened by the collision radius.
/// Checks points along its straight stem, a quarter of its length apart.
bool touches_plant(
		const MotionPage &page, int index, const MovingBody &body, float margin, const PageFrame &frame = {});

/// True if any plant of the page is.
bool touches_plants(const MotionPage &page, const MovingBody &body, float margin);

/// The point of a body's core that is nearest to `point`: `point` itself where it lies in the core.
glm::vec3 nearest_in_core(const MovingBody &body, const glm::vec3 &point);

/// Whether a body is not farther from a root than `reach` (m). 2 % more, for the rounding of what a stem's points are.
bool is_root_in_reach(const MovingBody &body, const glm::vec3 &root, float reach);

/// The point of a segment that is nearest to `point`.
glm::vec3 nearest_on_segment(const glm::vec3 &from, const glm::vec3 &to, const glm::vec3 &point);

/// Box in which a body can touch plants of a page, seen from above.
struct BodyReach {
	float low_x, high_x, low_z, high_z; ///< m.
};
/// Maximum number of rows of one call of rows_in_reach().
inline constexpr int REACH_ROWS = MotionPage::BLOCK_ROWS;
/// Writes the indices of the plants of rows [begin, end), REACH_ROWS at most, that may be in reach, in ascending order;
/// returns their number. Skips removed plants.
int rows_in_reach(const MotionPage &page, const BodyReach &reach, int begin, int end, int *indices);

/// True if the boxes of page and body overlap.
bool boxes_overlap(const MotionPage &page, const MovingBody &body);

/// Calls visit(indices, count) with the plants that may be in reach, REACH_ROWS at most per call. `indices` has
/// room for REACH_ROWS.
template <class Visit>
void for_each_block_in_reach(const MotionPage &page, const MovingBody &body, const Visit &visit) {
	if (!boxes_overlap(page, body)) {
		return;
	}
	const float thickness = std::max(page.collision_radius(), 0.0f);
	const BodyBox box = box_of(body);
	const BodyReach reach = { box.low.x - thickness, box.high.x + thickness, box.low.z - thickness,
		box.high.z + thickness };
	int indices[REACH_ROWS];
	for (int begin = 0; begin < page.size(); begin += REACH_ROWS) {
		const MotionPage::BlockBox &rows = page.block_box(begin / REACH_ROWS);
		if (rows.low_x > reach.high_x || rows.high_x < reach.low_x || rows.low_z > reach.high_z ||
				rows.high_z < reach.low_z) {
			continue;
		}
		const int end = std::min(begin + REACH_ROWS, page.size());
		const int count = rows_in_reach(page, reach, begin, end, indices);
		if (count > 0) {
			visit(indices, count);
		}
	}
}

template <class Visit> void for_each_in_reach(const MotionPage &page, const MovingBody &body, const Visit &visit) {
	const float thickness = std::max(page.collision_radius(), 0.0f);
	for_each_block_in_reach(page, body, [&](const int *indices, int count) {
		for (int i = 0; i < count; i++) {
			if (is_root_in_reach(body, page.root(indices[i]), page.length(indices[i]) + thickness)) {
				visit(indices[i]);
			}
		}
	});
}

} // namespace undergrowth

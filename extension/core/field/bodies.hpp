#pragma once

#include "field/field_page.hpp"

namespace undergrowth {

/// A moving capsule, or a sphere where both ends are the same point, that pushes plants out of its way.
struct FieldBody {
	glm::vec3 from = { 0.0f, 0.0f, 0.0f }; ///< m, field axes: the ends of its inner segment.
	glm::vec3 to = { 0.0f, 0.0f, 0.0f };
	float radius = 0.5f; ///< m, > 0.
	glm::vec3 velocity = { 0.0f, 0.0f, 0.0f }; ///< m/s.
};

/// Whether all numbers are finite and the radius is above 0.
bool is_valid(const FieldBody &body);

/// Pushes the plants of a swinging page out of a body: the tip, which is a sphere of the collision radius, and a point
/// of the upper stem, along their spheres, by as much as they are inside. What they move towards the body, seen from
/// it, they lose; nothing springs back from it. Tells how many plants were touched.
int push_plants(FieldPage &page, const FieldBody &body);

/// The point of a segment that is nearest to `point`.
glm::vec3 nearest_on_segment(const glm::vec3 &from, const glm::vec3 &to, const glm::vec3 &point);

} // namespace undergrowth

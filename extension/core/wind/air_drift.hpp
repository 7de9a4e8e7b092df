#pragma once

#include <glm/vec3.hpp>

namespace undergrowth {

/// How fast the roots of plants move through the air: they feel the wind less this velocity. Only its horizontal part
/// counts. Velocities have the axes of the roots.
struct AirDrift {
	const glm::vec3 *of_roots = nullptr; ///< m/s, of each plant of a page; null: they move as one field.
	glm::vec3 base = { 0.0f, 0.0f, 0.0f }; ///< m/s, of a root at the field's origin.
	glm::vec3 by_x = { 0.0f, 0.0f, 0.0f }; ///< 1/s, that and what each metre of a root's place adds to it.
	glm::vec3 by_y = { 0.0f, 0.0f, 0.0f };
	glm::vec3 by_z = { 0.0f, 0.0f, 0.0f };
	float share = 1.0f; ///< How much of it is felt.

	/// Whether anything moves.
	bool has_effect() const {
		const glm::vec3 none(0.0f);
		return share != 0.0f && (of_roots || base != none || by_x != none || by_y != none || by_z != none);
	}
	/// m/s, of the root of plant `index` of a page.
	glm::vec3 velocity(int index, const glm::vec3 &root) const {
		return share * (of_roots ? of_roots[index] : base + root.x * by_x + root.y * by_y + root.z * by_z);
	}
};

} // namespace undergrowth

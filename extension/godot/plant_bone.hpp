#pragma once

#include <godot_cpp/classes/skeleton3d.hpp>
#include <godot_cpp/variant/basis.hpp>

#include <glm/vec3.hpp>

namespace undergrowth {

/// The bone that shows where one plant points: all that posing needs, so that the simulation's rows of these are read
/// one after the other and no plant is touched.
struct PlantBone {
	godot::Skeleton3D *skeleton = nullptr; ///< Null where there is nothing to show: no skeleton, or hidden.
	godot::Basis to_local; ///< From the axes of the plant's directions to the plant's own.
	glm::vec3 posed = { 0.0f, 1.0f, 0.0f }; ///< What the bone shows now, in the plant's own axes.

	/// Turns the bone to `direction` (unit). Nothing where it points there already, within what can be seen.
	void turn_to(const glm::vec3 &direction);
};

} // namespace undergrowth

#pragma once

#include "motion/stem_state.hpp"

#include <godot_cpp/variant/basis.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <glm/vec3.hpp>

namespace undergrowth {

/// Position, rotation and scale of a `Plant3D`.
struct PlantTransform {
	godot::Basis axes; ///< Global axes of the plant, without scale.
	glm::vec3 root = { 0.0f, 0.0f, 0.0f }; ///< m, world axes.
	float scale_along = 1.0f; ///< Scale along the plant.

	/// Copies the transform of the node. If its scale is zero, the axes do not change.
	void follow(const godot::Transform3D &global);
	/// Returns the length (m) of a plant of `height` metres here; 0 returns that of a plant of 1 m without scale.
	float length_of(float height) const;
	/// Returns direction and rate of the tip and of a second mode (given in world axes) as twelve floats, in the
	/// plant's own axes.
	godot::PackedFloat32Array floats_of(const MotionState &state) const;
	/// Reads what floats_of() returns, with a unit direction. Six floats are those of the tip. Returns false and reads
	/// nothing if the number of floats is wrong, one is not finite, or there is no direction.
	bool read_state(const godot::PackedFloat32Array &floats, MotionState &into) const;
};

} // namespace undergrowth

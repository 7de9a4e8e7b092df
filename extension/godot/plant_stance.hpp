#pragma once

#include "motion/stem_state.hpp"

#include <godot_cpp/variant/basis.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <glm/vec3.hpp>

namespace undergrowth {

/// Where a plant that stands alone stands, and how it is turned and scaled.
struct PlantStance {
	godot::Basis axes; ///< Its global axes, without scale.
	glm::vec3 root = { 0.0f, 0.0f, 0.0f }; ///< m, world axes.
	float scale_along = 1.0f; ///< Its scale along itself.

	/// Takes over where its node stands. One that is scaled to nothing keeps its last axes.
	void follow(const godot::Transform3D &global);
	/// How long a plant of `height` metres stands there (m); as long as one of 1 m without scale where 0.
	float length_of(float height) const;
	/// A tip's direction and its rate, and the same of a second mode (world axes), as twelve floats in the plant's own
	/// axes.
	godot::PackedFloat32Array floats_of(const MotionState &state) const;
	/// The way back, with a unit direction; six are those of the tip. False, and nothing is read, where these are no
	/// such finite numbers with a direction.
	bool read_state(const godot::PackedFloat32Array &floats, MotionState &into) const;
};

} // namespace undergrowth

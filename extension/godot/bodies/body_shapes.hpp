#pragma once

#include "motion/bodies.hpp"

#include <godot_cpp/classes/collision_shape3d.hpp>
#include <godot_cpp/classes/node3d.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Returns the instance ids of the CollisionShape3Ds below a body, at any depth. Shapes below an Area3D are excluded,
/// because areas only detect and are often large. Shapes below another node of `group` are excluded, too.
std::vector<uint64_t> find_shape_holders(const godot::Node3D *body, const godot::StringName &group);

/// True if a CollisionShape3D has a shape that can push: a sphere, capsule, cylinder or box.
bool may_push(const godot::CollisionShape3D *holder);

/// Sets `body` to the shape of a CollisionShape3D, in world axes; `velocity` is not set. Returns false if it cannot
/// push now: disabled, or another shape. Spheres, capsules and boxes are exact, except for uneven scales and the edges
/// of boxes, which are rounded by up to 2 cm. A cylinder that is longer than wide becomes the capsule in it. A flatter
/// one becomes a box of its height and area.
bool shape_in_world(const godot::CollisionShape3D *holder, MovingBody &body);

/// Transforms a body to other axes. Its radius is exact for an even scale, else the mean along the ground. A
/// box retains right angles.
MovingBody transformed(const godot::Transform3D &to, const MovingBody &body);

} // namespace undergrowth

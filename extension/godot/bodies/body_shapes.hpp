#pragma once

#include "motion/bodies.hpp"

#include <godot_cpp/classes/collision_shape3d.hpp>
#include <godot_cpp/classes/node3d.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// The CollisionShape3Ds below a body, at any depth, by instance id. Those of an Area3D below it are no part of it
/// (they feel, and are often large), and neither are those of nodes that are in `group` themselves.
std::vector<uint64_t> find_shape_holders(const godot::Node3D *body, const godot::StringName &group);

/// Whether a CollisionShape3D has a shape that can push: a sphere, capsule, cylinder or box.
bool may_push(const godot::CollisionShape3D *holder);

/// What a CollisionShape3D pushes with, in world axes; `velocity` is not set. Spheres, capsules and boxes are exact but
/// for a box's edges, which are rounded by up to 2 cm, and for uneven scales. A cylinder that is longer than wide is
/// the capsule in it, a flatter one a box of its height and area. False where it cannot push now: disabled, or no such
/// shape.
bool shape_in_world(const godot::CollisionShape3D *holder, MovingBody &body);

/// A body brought into other axes. Its radius is exact where they are scaled evenly; else as it is in the mean along
/// the ground. A box stays one with right angles.
MovingBody transformed(const godot::Transform3D &to, const MovingBody &body);

} // namespace undergrowth

#pragma once

#include "field/bodies.hpp"

#include <godot_cpp/classes/node3d.hpp>

#include <vector>

namespace undergrowth {

/// Appends the spheres, capsules and cylinders (taken as capsules) among a body's collision shapes, in field axes.
/// Shapes that are disabled are left out. A body without such shapes adds nothing.
void add_shapes(const godot::Node3D *body, const godot::Transform3D &to_field, std::vector<FieldBody> &bodies);

} // namespace undergrowth

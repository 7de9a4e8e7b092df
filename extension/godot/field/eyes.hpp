#pragma once

#include <godot_cpp/classes/node3d.hpp>

#include <vector>

namespace undergrowth {

/// The positions of all cameras of the world of a node in the tree: that of the screen, and those of other viewports.
/// Cameras whose position is not finite are left out.
std::vector<godot::Vector3> find_eyes(const godot::Node3D *node);

} // namespace undergrowth

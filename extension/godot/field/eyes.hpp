#pragma once

#include <godot_cpp/classes/node3d.hpp>

#include <vector>

namespace undergrowth {

/// All cameras that look into the world of a node in the tree: that of the screen, and those of other viewports.
std::vector<godot::Vector3> find_eyes(const godot::Node3D *node);

} // namespace undergrowth

#pragma once

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/aabb.hpp>

#include <limits>
#include <vector>

namespace undergrowth {

/// The positions of all cameras of the world of a node in the tree: that of the screen, and those of other viewports.
/// Cameras whose position is not finite are left out.
std::vector<godot::Vector3> find_eyes(const godot::Node3D *node);

/// The same as they are drawn: after all nodes had the frame. All fields share one look-up per frame.
std::vector<godot::Vector3> find_drawn_eyes(const godot::Node3D *node);

/// How far from cameras something is seen (m); without cameras from anywhere.
struct SeenDistances {
	float nearest = 0.0f;
	float farthest = std::numeric_limits<float>::max();
};

/// The distances between the cameras of this frame and a box in the world. All fields share one look-up per frame.
SeenDistances find_seen_distances(const godot::Node3D *node, const godot::AABB &box);

} // namespace undergrowth

#pragma once

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/world3d.hpp>

#include <cstdint>

namespace undergrowth {

/// Returns the instance id of the World3D of a node; 0 outside of the tree.
inline uint64_t world_of(const godot::Node3D *node) {
	const godot::Ref<godot::World3D> world =
			node->is_inside_tree() ? node->get_world_3d() : godot::Ref<godot::World3D>();
	return world.is_valid() ? uint64_t(world->get_instance_id()) : 0;
}

} // namespace undergrowth

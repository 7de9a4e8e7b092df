#pragma once

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Watches nodes that a field depends on, such as its outline. Connects to the `changed` signals of their curves, and
/// compares their transforms and sizes when polled. Stores nodes by instance id, so they may be freed. Main thread.
class TransformWatcher {
public:
	/// Watches these nodes only; some may be null. `changed` is called when a curve changes.
	void watch(const godot::Node3D *field, const std::vector<godot::Node3D *> &wanted, const godot::Callable &changed);
	/// True if a node was moved relative to the field or resized since the last call.
	bool has_moved(const godot::Node3D *field);

private:
	struct Watched {
		uint64_t node; ///< Instance id.
		godot::Transform3D placed; ///< In the field's axes.
		godot::Variant size; ///< Null if the node has no size.
	};

	std::vector<Watched> nodes;
};

} // namespace undergrowth

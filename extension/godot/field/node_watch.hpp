#pragma once

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Other nodes that a field depends on, such as its outline: their curves tell of changes, their places are looked at.
class NodeWatch {
public:
	/// Watches those nodes, some of which may be null, and no others. `changed` is called where a curve changes.
	void watch(const godot::Node3D *field, const std::vector<godot::Node3D *> &wanted, const godot::Callable &changed);
	/// Whether any was moved against the field, or got another size, since it was asked last.
	bool has_moved(const godot::Node3D *field);

private:
	struct Watched {
		uint64_t node; ///< Instance id.
		godot::Transform3D placed; ///< In the field's axes.
		godot::Variant size; ///< Of one that has a size.
	};

	std::vector<Watched> nodes;
};

} // namespace undergrowth

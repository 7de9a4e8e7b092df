#pragma once

#include "field/field_recipe.hpp"
#include "field/node_watch.hpp"

#include <godot_cpp/classes/geometry_instance3d.hpp>

namespace undergrowth {

/// What a field hangs on and the engine does not tell of: its own properties of the node, an array that scripts append
/// to, other nodes' places. It is looked at now and then.
class UntoldChanges {
public:
	/// What is otherwise than it was seen last.
	struct Found {
		bool range = false; ///< How far the node is seen, or how finely.
		bool material = false; ///< That overrides those of its species.
		bool exclusions = false;
		bool area = false; ///< A node that gives room, or keeps places free.
		bool ground = false;
	};

	/// Once a frame: whether to look in this one.
	bool is_time() { return frames_since_look++ % FRAMES_BETWEEN_LOOKS == 0; }
	Found look(const godot::GeometryInstance3D *node, const FieldProperties &properties);
	bool sees_other_exclusions(const StandOptions &options) const { return seen_exclusions != options.exclusions; }
	void see_exclusions(const StandOptions &options) { seen_exclusions = options.exclusions.duplicate(); }
	/// The nodes that `options` name, and no others. Outline and exclusions are live: a point that is dragged, a path
	/// that is moved, another field that grows. Curves tell of themselves, by _on_area_changed() and
	/// _on_ground_changed() of the node.
	void watch(godot::Node3D *node, const StandOptions &options);

private:
	static constexpr int FRAMES_BETWEEN_LOOKS = 8;

	SightRange seen_range;
	uint64_t seen_material = 0; ///< Instance id.
	godot::TypedArray<godot::NodePath> seen_exclusions;
	NodeWatch area;
	NodeWatch ground;
	int frames_since_look = 0;
};

} // namespace undergrowth

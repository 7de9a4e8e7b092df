#pragma once

#include "field/build/build_input.hpp"
#include "field/transform_watcher.hpp"

#include <godot_cpp/classes/geometry_instance3d.hpp>

namespace undergrowth {

/// Detects changes without a signal: of the node's engine properties, of the array of exclusions (scripts may append to
/// it), and of the transforms of other nodes. Compares them with stored copies every 8 frames. Main thread.
class DependencyPoller {
public:
	/// Differences since the last poll().
	struct Found {
		bool range = false; ///< The node's visibility range or LOD bias.
		bool material = false; ///< The material override.
		bool exclusions = false; ///< The array of exclusions.
		bool area = false; ///< A node of the outline or the exclusions.
		bool ground = false; ///< The node of the ground, or one that habitats use.
	};

	/// Call once per frame. Returns true in the frames to call poll() in.
	bool is_time() { return frames_since_poll++ % FRAMES_BETWEEN_POLLS == 0; }
	Found poll(const godot::GeometryInstance3D *node, const FieldProperties &properties);
	bool has_other_exclusions(const PlacementOptions &options) const { return seen_exclusions != options.exclusions; }
	void store_exclusions(const PlacementOptions &options) { seen_exclusions = options.exclusions.duplicate(); }
	/// Watches the nodes of outline, exclusions, ground and habitats in `options`, and no other ones. Polling detects
	/// moved nodes and resized fields. Changed curves emit signals, which call _on_area_changed() or
	/// _on_ground_changed() of the node.
	void watch(godot::Node3D *node, const PlacementOptions &options);

private:
	static constexpr int FRAMES_BETWEEN_POLLS = 8;

	SightRange seen_range;
	uint64_t seen_material = 0; ///< Instance id.
	godot::TypedArray<godot::NodePath> seen_exclusions;
	TransformWatcher area;
	TransformWatcher ground;
	int frames_since_poll = 0;
};

} // namespace undergrowth

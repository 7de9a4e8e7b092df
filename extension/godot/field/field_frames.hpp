#pragma once

#include "base/queued_call.hpp"

#include <godot_cpp/classes/node.hpp>

namespace undergrowth {

/// Connects a field to frame signals besides those of its node. They also arrive while the tree is paused, because a
/// loading screen may wait for the field. Calls methods of the node by their names, because connections outlive a
/// reload of the library.
class FieldFrames {
public:
	explicit FieldFrames(godot::Node *of) : node(of), ending(of, "_on_frame_ending") {}

	/// Starts or stops calls of _on_tree_frame() and _on_physics_frame() in each frame. The node must be in a tree.
	void follow(bool on);
	/// Starts or stops calls of _on_frame_drawn() before each frame is drawn.
	void follow_drawing(bool on);
	/// Calls _on_frame_ending() once, after all nodes have processed this frame.
	void queue_end() { ending.queue(); }
	/// Call at the start of _on_frame_ending().
	void begin_end() { ending.begin(); }

private:
	godot::Node *node;
	QueuedCall ending;
};

} // namespace undergrowth

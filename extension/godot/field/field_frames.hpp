#pragma once

#include "queued_call.hpp"

#include <godot_cpp/classes/node.hpp>

namespace undergrowth {

/// The frames that a field hears of beside those of its node, in a tree that is paused, too: somebody may wait for it
/// to grow behind a loading screen. What is called are methods of the node, by their names, for connections outlive a
/// reload of the library.
class FieldFrames {
public:
	explicit FieldFrames(godot::Node *of) : node(of), ending(of, "_on_frame_ending") {}

	/// _on_tree_frame() and _on_physics_frame() in each, from now on or no more. In a tree.
	void follow(bool on);
	/// _on_frame_drawn() before each is drawn.
	void follow_drawing(bool on);
	/// _on_frame_ending() once, after all nodes had this one.
	void queue_end() { ending.queue(); }
	/// It is called.
	void begin_end() { ending.begin(); }

private:
	godot::Node *node;
	QueuedCall ending;
};

} // namespace undergrowth

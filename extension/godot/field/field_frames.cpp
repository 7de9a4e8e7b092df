#include "field/field_frames.hpp"

#include "base/follow_changes.hpp"

#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/scene_tree.hpp>

using namespace godot;

namespace undergrowth {

void FieldFrames::follow(bool on) {
	SceneTree *tree = node->get_tree();
	follow_signal(tree, "process_frame", Callable(node, "_on_tree_frame"), on);
	follow_signal(tree, "physics_frame", Callable(node, "_on_physics_frame"), on);
}

void FieldFrames::follow_drawing(bool on) {
	static const char *const DRAW_SIGNAL = "frame_pre_draw"; // After all code that moves cameras.
	follow_signal(RenderingServer::get_singleton(), DRAW_SIGNAL, Callable(node, "_on_frame_drawn"), on);
}

} // namespace undergrowth

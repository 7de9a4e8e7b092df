#include "field/eyes.hpp"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

using namespace godot;

namespace undergrowth {

static const char *const VIEWPORTS = "_viewports"; // The engine's own group.

std::vector<Vector3> find_eyes(const Node3D *node) {
	std::vector<Vector3> eyes;
	const TypedArray<Node> viewports = node->get_tree()->get_nodes_in_group(VIEWPORTS);
	for (int64_t i = 0; i < viewports.size(); i++) {
		const Viewport *viewport = Object::cast_to<Viewport>(viewports[i]);
		const Camera3D *camera = viewport ? viewport->get_camera_3d() : nullptr;
		if (camera && camera->get_world_3d() == node->get_world_3d() && camera->get_global_position().is_finite()) {
			eyes.push_back(camera->get_global_position());
		}
	}
	return eyes;
}

} // namespace undergrowth

#include "field/cameras.hpp"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>
#include <cstdint>

using namespace godot;

namespace undergrowth {

static const char *const VIEWPORTS = "_viewports"; // A group of the engine.

/// A camera of any world.
struct WorldCamera {
	uint64_t world = 0; ///< Instance id.
	Vector3 place;
};

static uint64_t world_of(const Node3D *node) {
	const Ref<World3D> world = node->get_world_3d();
	return world.is_valid() ? uint64_t(world->get_instance_id()) : 0;
}

static std::vector<WorldCamera> find_cameras(SceneTree *tree) {
	std::vector<WorldCamera> cameras;
	const TypedArray<Node> viewports = tree->get_nodes_in_group(VIEWPORTS);
	for (int64_t i = 0; i < viewports.size(); i++) {
		const Viewport *viewport = Object::cast_to<Viewport>(viewports[i]);
		const Camera3D *camera = viewport ? viewport->get_camera_3d() : nullptr;
		if (camera && camera->get_global_position().is_finite()) {
			cameras.push_back({ world_of(camera), camera->get_global_position() });
		}
	}
	return cameras;
}

static std::vector<Vector3> places_in(const Node3D *node, const std::vector<WorldCamera> &cameras) {
	const uint64_t world = world_of(node);
	std::vector<Vector3> positions;
	for (const WorldCamera &camera : cameras) {
		if (camera.world == world) {
			positions.push_back(camera.place);
		}
	}
	return positions;
}

std::vector<Vector3> find_camera_positions(const Node3D *node) {
	return places_in(node, find_cameras(node->get_tree()));
}

/// All cameras at one moment of each frame.
class FrameCameras {
public:
	const std::vector<WorldCamera> &now(const Node3D *node) {
		const uint64_t this_frame = Engine::get_singleton()->get_process_frames();
		if (frame != this_frame) {
			frame = this_frame;
			cameras = find_cameras(node->get_tree());
		}
		return cameras;
	}

private:
	uint64_t frame = UINT64_MAX;
	std::vector<WorldCamera> cameras;
};

std::vector<Vector3> find_drawn_camera_positions(const Node3D *node) {
	static FrameCameras drawn;
	return places_in(node, drawn.now(node));
}

SeenDistances find_seen_distances(const Node3D *node, const AABB &box) {
	static FrameCameras of_frame;
	SeenDistances seen;
	for (const Vector3 &position : places_in(node, of_frame.now(node))) {
		const float middle = position.distance_to(box.get_center());
		const float radius = 0.5f * box.size.length();
		const bool is_first = seen.farthest == SeenDistances().farthest;
		seen.nearest = is_first ? middle - radius : std::min(seen.nearest, middle - radius);
		seen.farthest = is_first ? middle + radius : std::max(seen.farthest, middle + radius);
	}
	return seen;
}

} // namespace undergrowth

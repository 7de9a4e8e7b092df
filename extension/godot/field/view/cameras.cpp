#include "field/view/cameras.hpp"

#include "base/renderer.hpp"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/compositor.hpp>
#include <godot_cpp/classes/compositor_effect.hpp>
#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include "conventions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

using namespace godot;

namespace undergrowth {

/// A camera of any world.
struct WorldCamera {
	uint64_t world = 0; ///< Instance id.
	uint32_t layers = 0; ///< Render layers that it draws.
	DrawingCamera camera;

	bool draws(uint64_t in_world, uint32_t in_layers) const { return world == in_world && (layers & in_layers) != 0; }
};

static bool has_effects_with_vectors(const Ref<Compositor> &compositor) {
	if (compositor.is_null()) {
		return false;
	}
	const Array effects = compositor->get_compositor_effects();
	for (int64_t i = 0; i < effects.size(); i++) {
		const Ref<CompositorEffect> effect = effects[i];
		if (effect.is_valid() && effect->get_enabled() && effect->get_needs_motion_vectors()) {
			return true;
		}
	}
	return false;
}

// That of the camera, or else of the world's first WorldEnvironment.
static Ref<Compositor> compositor_of(const Camera3D *camera) {
	const Ref<World3D> world = camera->get_world_3d();
	if (camera->get_compositor().is_valid() || world.is_null()) {
		return camera->get_compositor();
	}
	const String group = "_world_compositor_" + String::num_int64(world->get_scenario().get_id()); // Of the engine.
	const Node *environment = camera->get_tree()->get_first_node_in_group(group);
	return environment ? Ref<Compositor>(environment->get("compositor")) : Ref<Compositor>();
}

// Other renderers write no vectors for multimeshes.
static bool needs_vectors(const Viewport *viewport, const Camera3D *camera) {
	if (!is_forward_plus()) {
		return false;
	}
	const Viewport::Scaling3DMode scaling = viewport->get_scaling_3d_mode();
	return viewport->is_using_taa() || scaling == Viewport::SCALING_3D_MODE_FSR2 ||
			scaling == Viewport::SCALING_3D_MODE_METALFX_TEMPORAL || has_effects_with_vectors(compositor_of(camera));
}

// Of cameras with a perspective picture in the middle. Headsets and other projections have no cone.
static DrawingCamera describe_camera(const Viewport *viewport, const Camera3D *camera) {
	static constexpr float MARGIN = 0.12f; // rad: more than NearPlants lets a camera turn.
	const Transform3D placed = camera->get_camera_transform();
	DrawingCamera into;
	into.place = camera->get_global_position();
	into.has_vectors = needs_vectors(viewport, camera);
	into.forward = -placed.basis.get_column(2).normalized();
	const Vector2 size = viewport->get_visible_rect().size;
	if (camera->get_projection() != Camera3D::PROJECTION_PERSPECTIVE ||
			const_cast<Viewport *>(viewport)->is_using_xr() || size.x <= 0.0f || size.y <= 0.0f ||
			!into.forward.is_finite()) {
		return into;
	}
	const bool keeps_height = camera->get_keep_aspect_mode() == Camera3D::KEEP_HEIGHT;
	const float half = std::tan(0.5f * float(camera->get_fov()) * float(PI) / 180.0f);
	const float aspect = float(size.x / size.y);
	const float up = keeps_height ? half : half / aspect;
	const float corner = std::atan(up * std::sqrt(1.0f + aspect * aspect)) + MARGIN;
	into.has_cone = corner < 0.5f * float(PI);
	into.cone_cosine = into.has_cone ? std::cos(corner) : -1.0f;
	return into;
}

static uint64_t world_of(const Node3D *node) {
	const Ref<World3D> world = node->get_world_3d();
	return world.is_valid() ? uint64_t(world->get_instance_id()) : 0;
}

static std::vector<WorldCamera> find_cameras(SceneTree *tree) {
	static const StringName &viewport_group = *new StringName("_viewports"); // A group of the engine.
	std::vector<WorldCamera> cameras;
	const TypedArray<Node> viewports = tree->get_nodes_in_group(viewport_group);
	for (int64_t i = 0; i < viewports.size(); i++) {
		const Viewport *viewport = Object::cast_to<Viewport>(viewports[i]);
		const Camera3D *camera = viewport ? viewport->get_camera_3d() : nullptr;
		if (camera && camera->get_global_position().is_finite()) {
			cameras.push_back({ world_of(camera), camera->get_cull_mask(), describe_camera(viewport, camera) });
		}
	}
	return cameras;
}

static std::vector<DrawingCamera> cameras_in(const VisualInstance3D *node, const std::vector<WorldCamera> &cameras) {
	const uint64_t world = world_of(node);
	const uint32_t layers = node->get_layer_mask();
	std::vector<DrawingCamera> positions;
	for (const WorldCamera &camera : cameras) {
		if (camera.draws(world, layers)) {
			positions.push_back(camera.camera);
		}
	}
	return positions;
}

static std::vector<Vector3> places_in(const VisualInstance3D *node, const std::vector<WorldCamera> &cameras) {
	std::vector<Vector3> places;
	for (const DrawingCamera &position : cameras_in(node, cameras)) {
		places.push_back(position.place);
	}
	return places;
}

std::vector<Vector3> find_camera_positions(const VisualInstance3D *node) {
	return places_in(node, find_cameras(node->get_tree()));
}

/// All cameras at one moment of each frame.
class FrameCameras {
public:
	const std::vector<WorldCamera> &now(SceneTree *tree) {
		const uint64_t this_frame = Engine::get_singleton()->get_process_frames();
		if (frame != this_frame) {
			frame = this_frame;
			cameras = find_cameras(tree);
		}
		return cameras;
	}

private:
	uint64_t frame = UINT64_MAX;
	std::vector<WorldCamera> cameras;
};

std::vector<DrawingCamera> find_drawing_cameras(const VisualInstance3D *node) {
	static FrameCameras drawn;
	return cameras_in(node, drawn.now(node->get_tree()));
}

SeenDistances find_seen_distances(const VisualInstance3D *node, uint64_t world, const AABB &box) {
	static FrameCameras of_frame;
	SeenDistances seen;
	const float radius = 0.5f * box.size.length();
	bool is_first = true;
	const uint32_t layers = node->get_layer_mask();
	for (const WorldCamera &camera : of_frame.now(node->get_tree())) {
		if (camera.draws(world, layers)) {
			const float middle = camera.camera.place.distance_to(box.get_center());
			seen.nearest = is_first ? middle - radius : std::min(seen.nearest, middle - radius);
			seen.farthest = is_first ? middle + radius : std::max(seen.farthest, middle + radius);
			is_first = false;
		}
	}
	return seen;
}

} // namespace undergrowth

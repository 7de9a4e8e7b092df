#pragma once

#include <godot_cpp/classes/visual_instance3d.hpp>
#include <godot_cpp/variant/aabb.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace undergrowth {

/// Returns the positions of all cameras in the world of a node that draw one of its render layers: those of the screen
/// and of all other viewports. Skips cameras with a position that is not finite. The node must be in a tree.
std::vector<godot::Vector3> find_camera_positions(const godot::VisualInstance3D *node);

/// A camera that draws plants.
struct DrawingCamera {
	godot::Vector3 place; ///< World axes.
	godot::Vector3 forward; ///< Direction of view, of length 1.
	/// Cosine of the angle between `forward` and the farthest visible direction, plus a margin for turns.
	float cone_cosine = -1.0f;
	bool has_cone = false; ///< False: it may see in all directions.
	bool has_vectors = false; ///< Its picture needs motion vectors, for TAA, FSR 2 or effects.
};

/// The same at the moment of drawing, after all nodes have processed the frame. All fields share one look-up per frame.
std::vector<DrawingCamera> find_drawing_cameras(const godot::VisualInstance3D *node);

/// Smallest and largest distance from a camera (m). Without cameras: every distance.
struct SeenDistances {
	float nearest = 0.0f;
	float farthest = std::numeric_limits<float>::max();
};

/// Returns the distances between a box in the world with the instance id `world` and the cameras of this frame that
/// draw one of the node's render layers. All fields share one look-up per frame.
SeenDistances find_seen_distances(const godot::VisualInstance3D *node, uint64_t world, const godot::AABB &box);

} // namespace undergrowth

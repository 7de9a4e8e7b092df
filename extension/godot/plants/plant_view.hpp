#pragma once

#include "plants/part_skeleton.hpp"
#include "plants/plant_motion.hpp"

#include <godot_cpp/classes/mesh_instance3d.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/skin_reference.hpp>

#include <memory>

namespace undergrowth {

/// The drawing of a `Plant3D`: a mesh on a skeleton, both internal children of the plant's node. They are never saved
/// with the scene. Main thread.
class PlantView {
public:
	/// `of`: node of the plant. `moving` has the bone that poses this drawing.
	PlantView(godot::Node3D *of, PlantMotion &moving) : node(of), motion(moving) {}

	/// Shows another plant. Call follow_drawn() after it.
	void show(const SampledPlant &sampled);
	/// Finds the children that the library created before a reload.
	void find_children();
	/// Drops a skeleton that is no longer a child of the plant, because a script freed or moved it. Returns true if
	/// there was one.
	bool lose_skeleton();
	/// Gets the renderer's skeleton, which exists when the mesh instance is in the tree.
	void find_drawn();
	/// Sets what the bone poses. `is_seen`: the plant is in the tree and visible. `calm`: rest direction, in the
	/// plant's own axes.
	void follow_drawn(bool is_seen, const glm::vec3 &calm);
	/// Applies other constants of the stem. Returns false if its bones must be built again.
	bool follow_stem(const std::shared_ptr<const StemConstants> &stem);
	/// True if the mesh of a plant of parts was built for another rest.
	bool rests_elsewhere(const glm::vec2 &rest) const { return has_parts && rest != built_rest; }
	/// Number of joints of the stem; 0 if it is straight.
	int joint_count() const { return parts ? parts->joint_count() : 0; }
	/// Returns the vector from the root to a point on the plant with this tip direction (unit). `share` is 0 at the
	/// root and 1 at the tip. The unit is the length of the plant, in its own axes.
	glm::vec3 arm(const glm::vec3 &direction, float share) const;
	/// Call when a script requests the skeleton: the node then has its pose in every frame. Returns false if it was
	/// held.
	bool hold_skeleton();

	godot::Skeleton3D *get_skeleton() const { return skeleton; }
	/// Null until a plant is shown.
	const godot::Ref<godot::ArrayMesh> &get_mesh() const { return mesh; }
	/// Height of the shown plant without the node's scale (m); 0 without a plant.
	float height() const { return built_height; }
	/// Box around all deflections, in the plant's own axes; empty without a plant.
	godot::AABB reach() const;

private:
	godot::Node3D *node;
	PlantMotion &motion;
	godot::Skeleton3D *skeleton = nullptr;
	uint64_t mesh_instance = 0; // Instance id: a grandchild may be freed without a notification.
	godot::Ref<godot::SkinReference> drawn; // The renderer's skeleton. It must outlive its id in the bone.
	bool is_held = false; // A script requested the skeleton.
	godot::Ref<godot::ArrayMesh> mesh;
	std::unique_ptr<PartSkeleton> parts; // For a plant of parts that swing.
	float built_height = 0.0f; // m.
	glm::vec2 built_rest = { 0.0f, 0.0f };
	bool has_parts = false;

	void make_children();
	void make_mesh_instance();
	void set_up_bones();
	godot::MeshInstance3D *get_mesh_instance() const;
};

} // namespace undergrowth

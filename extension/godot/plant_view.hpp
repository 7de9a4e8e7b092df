#pragma once

#include "part_skeleton.hpp"
#include "plant_motion.hpp"

#include <godot_cpp/classes/mesh_instance3d.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/skin_reference.hpp>

#include <memory>

namespace undergrowth {

/// What is drawn of a plant that stands alone: a mesh on a skeleton, both internal children of the plant's node, which
/// are never saved with the scene. Main thread.
class PlantView {
public:
	/// For the plant's node. `moving` has the bone that poses what is shown here.
	PlantView(godot::Node3D *of, PlantMotion &moving) : node(of), motion(moving) {}

	/// Shows another plant from now on. follow_drawn() follows.
	void show(const SampledPlant &sampled);
	/// A library that was reloaded finds the children that its former self made.
	void find_children();
	/// Forgets a skeleton that is no child of the plant any more: a script may free or take away what it was given.
	/// Tells whether there was one.
	bool lose_skeleton();
	/// What the renderer has of the skeleton, which is known once the mesh instance is in the tree.
	void find_drawn();
	/// Tells the bone what it poses. `is_seen`: the plant is in the tree and visible; `calm` is where it points at
	/// rest, in its own axes.
	void follow_drawn(bool is_seen, const glm::vec3 &calm);
	/// The stem's constants are others. False where its bones have to be built anew.
	bool follow_stem(const std::shared_ptr<const StemConstants> &stem);
	/// Whether the mesh says of a plant of parts that it rests elsewhere.
	bool rests_elsewhere(const glm::vec2 &rest) const { return has_parts && rest != built_rest; }
	/// Of the stem; 0 where it is straight.
	int joint_count() const { return parts ? parts->joint_count() : 0; }
	/// From the root to a place on the plant whose tip points so (unit), 0 the root to 1 the tip, in lengths of the
	/// plant; all in its own axes.
	glm::vec3 arm(const glm::vec3 &direction, float share) const;
	/// Somebody asked for the skeleton, so its node knows its pose in every frame. False where it did before.
	bool hold_skeleton();

	godot::Skeleton3D *get_skeleton() const { return skeleton; }
	/// Null until a plant was shown.
	const godot::Ref<godot::ArrayMesh> &get_mesh() const { return mesh; }
	/// Of the plant that is shown, without the node's scale (m); 0 until there is one.
	float height() const { return built_height; }
	/// The box around all deflections, in the plant's own axes; empty until there is one.
	godot::AABB reach() const;

private:
	godot::Node3D *node;
	PlantMotion &motion;
	godot::Skeleton3D *skeleton = nullptr;
	uint64_t mesh_instance = 0; // Instance id: a grandchild may be freed without a word to the plant.
	godot::Ref<godot::SkinReference> drawn; // The renderer's skeleton, which must not go before its id in the bone.
	bool is_held = false; // Somebody asked for the skeleton.
	godot::Ref<godot::ArrayMesh> mesh;
	std::unique_ptr<PartSkeleton> parts; // Of a plant of parts that swing.
	float built_height = 0.0f; // m.
	glm::vec2 built_rest = { 0.0f, 0.0f };
	bool has_parts = false;

	void make_children();
	void make_mesh_instance();
	void set_up_bones();
	godot::MeshInstance3D *get_mesh_instance() const;
};

} // namespace undergrowth

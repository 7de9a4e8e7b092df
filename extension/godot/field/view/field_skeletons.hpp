#pragma once

#include "field/view/field_render_setup.hpp"
#include "plants/part_skeleton.hpp"

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/skeleton3d.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Owns the Skeleton3D nodes that show single plants of a field, each with a skinned mesh as in a Plant3D. The nodes
/// are children of an internal node of the field, so the scene does not save them. Unused nodes are hidden and reused.
/// Scripts may free any node at any time, so nodes are stored by instance id. Main thread.
class FieldSkeletons {
public:
	/// Frees the internal node of an earlier owner, which a duplicated field or a reloaded library leaves among the
	/// field's children.
	void remove_strays(godot::Node3D *field) const;

	/// Returns an unused or new skeleton with `mesh` at `place` (field axes, m). All bones are at rest. `parts`: the
	/// bones of a plant of parts or of a stem; null: root and tip only.
	godot::Skeleton3D *take(godot::Node3D *field, const godot::Transform3D &place,
			const godot::Ref<godot::ArrayMesh> &mesh, const PartSkeleton *parts, const InstanceRenderFlags &flags);
	static void apply_flags(godot::Skeleton3D *skeleton, const InstanceRenderFlags &flags);
	/// Hides a skeleton for later use. If scripts added children to it, frees the skeleton with them instead.
	void give_back(godot::Skeleton3D *skeleton);
	/// Frees all unused skeletons.
	void clear();

	/// Returns the node of an instance id; null if a script has freed it.
	static godot::Skeleton3D *node(uint64_t skeleton);
	/// Rotates the tip's bone by `turn`, so that the mesh bends as in the shader of fields.
	static void pose(godot::Skeleton3D *skeleton, const godot::Quaternion &turn);

private:
	uint64_t holder = 0; ///< Instance id of the internal node; 0: none.
	std::vector<uint64_t> idle; ///< Instance ids of unused skeletons.

	godot::Node *find_holder(godot::Node3D *field);
	godot::Skeleton3D *make(godot::Node3D *field);
};

} // namespace undergrowth

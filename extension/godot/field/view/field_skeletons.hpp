#pragma once

#include "field/view/field_render_setup.hpp"
#include "plants/part_skeleton.hpp"

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/skeleton3d.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Plants of a field that are shown as nodes: a Skeleton3D with a skinned mesh, as in a Plant3D. They are children of
/// an internal node of the field, so that they are never saved, and are reused for other plants. Scripts may free any
/// of them at any time.
class FieldSkeletons {
public:
	/// Removes the internal node that a duplicated field, or one of a reloaded library, has among its children.
	void remove_strays(godot::Node3D *field) const;

	/// Returns a skeleton at `place` (field axes) that shows `mesh`, with the bones of its `parts`, if any. All bones
	/// are at rest.
	godot::Skeleton3D *take(godot::Node3D *field, const godot::Transform3D &place,
			const godot::Ref<godot::ArrayMesh> &mesh, const PartSkeleton *parts, const InstanceRenderFlags &flags);
	static void apply_flags(godot::Skeleton3D *skeleton, const InstanceRenderFlags &flags);
	/// Hides a skeleton for later use. Frees it if scripts have added children to it, together with them.
	void give_back(godot::Skeleton3D *skeleton);
	/// Frees all unused skeletons.
	void clear();

	/// Returns the node of an instance id; null if a script has freed it.
	static godot::Skeleton3D *node(uint64_t skeleton);
	/// Turns the tip's bone so that it bends the mesh like the shader of fields.
	static void pose(godot::Skeleton3D *skeleton, const godot::Quaternion &turn);

private:
	uint64_t holder = 0; ///< Instance id.
	std::vector<uint64_t> idle;

	godot::Node *find_holder(godot::Node3D *field);
	godot::Skeleton3D *make(godot::Node3D *field);
};

} // namespace undergrowth

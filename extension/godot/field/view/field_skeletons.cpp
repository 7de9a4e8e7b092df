#include "field/view/field_skeletons.hpp"

#include "base/new_object.hpp"
#include "species/shared_resources.hpp"

#include <godot_cpp/classes/mesh_instance3d.hpp>
#include <godot_cpp/core/object.hpp>

using namespace godot;

namespace undergrowth {

static const char *const HOLDER_NAME = "FieldSkeletons";
static const char *const SKELETON_NAME = "PlantSkeleton";
static const char *const MESH_NAME = "PlantMesh";
static constexpr int TIP_BONE = 1;

static MeshInstance3D *mesh_of(const Skeleton3D *skeleton) {
	return Object::cast_to<MeshInstance3D>(skeleton->get_node_or_null(NodePath(MESH_NAME)));
}

void FieldSkeletons::remove_strays(Node3D *field) const {
	Node *stray = field->get_node_or_null(NodePath(HOLDER_NAME));
	if (stray && stray->get_instance_id() != holder) {
		field->remove_child(stray);
		stray->queue_free();
	}
}

Node *FieldSkeletons::find_holder(Node3D *field) {
	Node *found = Object::cast_to<Node>(ObjectDB::get_instance(holder));
	if (!found) {
		found = new_node<Node3D>();
		found->set_name(HOLDER_NAME);
		field->add_child(found, false, Node::INTERNAL_MODE_BACK);
		holder = found->get_instance_id();
	}
	return found;
}

Skeleton3D *FieldSkeletons::make(Node3D *field) {
	Skeleton3D *skeleton = new_node<Skeleton3D>();
	skeleton->set_name(SKELETON_NAME);
	MeshInstance3D *drawn = new_node<MeshInstance3D>();
	drawn->set_name(MESH_NAME);
	skeleton->add_child(drawn, false, Node::INTERNAL_MODE_FRONT);
	drawn->set_skeleton_path(NodePath(".."));
	find_holder(field)->add_child(skeleton, true);
	return skeleton;
}

Skeleton3D *FieldSkeletons::take(Node3D *field, const Transform3D &place, const Ref<ArrayMesh> &mesh,
		const PartSkeleton *parts, const InstanceRenderFlags &flags) {
	Skeleton3D *skeleton = nullptr;
	while (!skeleton && !idle.empty()) {
		skeleton = node(idle.back());
		idle.pop_back();
		if (skeleton && !mesh_of(skeleton)) {
			skeleton->queue_free(); // A script has removed its mesh.
			skeleton = nullptr;
		}
	}
	skeleton = skeleton ? skeleton : make(field);
	MeshInstance3D *drawn = mesh_of(skeleton);
	PartSkeleton::set_up(skeleton, parts);
	drawn->set_skin(PartSkeleton::skin_of(parts));
	drawn->set_mesh(mesh);
	apply_flags(skeleton, flags);
	// Linear blend skinning moves no vertex farther from the root than it is at rest.
	const AABB box = mesh->get_aabb();
	const float reach = box.position.abs().max(box.get_end().abs()).length();
	drawn->set_custom_aabb(AABB().grow(reach));
	skeleton->set_transform(place);
	skeleton->set_visible(true);
	return skeleton;
}

void FieldSkeletons::apply_flags(Skeleton3D *skeleton, const InstanceRenderFlags &flags) {
	MeshInstance3D *drawn = mesh_of(skeleton);
	if (drawn) {
		drawn->set_layer_mask(flags.layers);
		drawn->set_transparency(flags.transparency);
		drawn->set_gi_mode(GeometryInstance3D::GIMode(flags.gi_mode));
		drawn->set_cast_shadows_setting(flags.casts_shadows ? GeometryInstance3D::SHADOW_CASTING_SETTING_ON
															: GeometryInstance3D::SHADOW_CASTING_SETTING_OFF);
	}
}

void FieldSkeletons::give_back(Skeleton3D *skeleton) {
	if (skeleton->get_child_count(false) > 0) {
		// At the end of the frame, so that a script that gets the signal can move the children before.
		skeleton->queue_free();
		return;
	}
	skeleton->set_visible(false);
	idle.push_back(skeleton->get_instance_id());
}

void FieldSkeletons::clear() {
	for (const uint64_t id : idle) {
		if (Skeleton3D *skeleton = node(id)) {
			skeleton->queue_free();
		}
	}
	idle.clear();
}

Skeleton3D *FieldSkeletons::node(uint64_t skeleton) {
	return Object::cast_to<Skeleton3D>(ObjectDB::get_instance(skeleton));
}

void FieldSkeletons::pose(Skeleton3D *skeleton, const Quaternion &turn) {
	if (skeleton->get_bone_count() > TIP_BONE) {
		skeleton->set_bone_pose_rotation(TIP_BONE, turn);
	}
}

} // namespace undergrowth

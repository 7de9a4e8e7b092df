#include "plants/plant_view.hpp"

#include "base/new_object.hpp"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static const char *const SKELETON_NAME = "PlantSkeleton";
static const char *const MESH_NAME = "PlantMesh";
static constexpr float MIN_HEIGHT = 1e-3f; // Of a unit rest direction, plus 1.

void PlantView::show(const SampledPlant &sampled) {
	mesh = sampled.build();
	motion.bone().parts = nullptr;
	parts = PartSkeleton::of(sampled);
	built_height = sampled.height;
	built_rest = sampled.rest;
	has_parts = sampled.grown != nullptr;
	if (!skeleton) {
		find_children();
	}
	if (!skeleton) {
		make_children();
	} else if (!get_mesh_instance()) {
		make_mesh_instance();
	}
	set_up_bones();
	get_mesh_instance()->set_mesh(mesh);
	get_mesh_instance()->set_custom_aabb(reach());
	find_drawn();
}

void PlantView::find_children() {
	skeleton = Object::cast_to<Skeleton3D>(node->get_node_or_null(SKELETON_NAME));
	motion.bone().posed = glm::vec3(NAN); // Forces an update by the next pose.
	is_held = true; // A script may hold it.
	const Node *found = skeleton ? skeleton->get_node_or_null(MESH_NAME) : nullptr;
	mesh_instance = found ? uint64_t(found->get_instance_id()) : 0;
}

bool PlantView::lose_skeleton() {
	if (!skeleton || skeleton->get_parent() == node) {
		return false;
	}
	skeleton = nullptr;
	mesh_instance = 0;
	find_drawn();
	return true;
}

void PlantView::find_drawn() {
	const MeshInstance3D *shown = get_mesh_instance();
	drawn = shown ? shown->get_skin_reference() : Ref<SkinReference>();
}

void PlantView::follow_drawn(bool is_seen, const glm::vec3 &calm) {
	PlantBone &bone = motion.bone();
	const PlantBone before = bone;
	bone.skeleton = is_seen ? skeleton : nullptr;
	bone.drawn = drawn.is_valid() ? drawn->get_skeleton() : RID();
	bone.is_held = is_held;
	bone.parts = parts.get();
	bone.is_calm = !parts; // Until the first pose.
	if (parts) {
		parts->stem.rest = glm::vec2(calm.x, calm.z) / std::max(1.0f + calm.y, MIN_HEIGHT);
	}
	if (bone.skeleton != before.skeleton || bone.drawn != before.drawn || bone.is_held != before.is_held) {
		const bool is_unseen = drawn.is_valid() && !bone.drawn.is_valid() && !is_held;
		bone.way = is_unseen ? PlantBone::Way::UNSEEN : PlantBone::Way::NODE; // Until the renderer has the skeleton.
	}
}

bool PlantView::follow_stem(const std::shared_ptr<const StemConstants> &stem) {
	const bool is_same = (stem ? stem->joints : 0) == joint_count();
	if (is_same && stem) {
		parts->set_stem(stem);
		motion.bone().is_calm = false; // Its bend may be different.
	}
	return is_same || mesh.is_null();
}

glm::vec3 PlantView::arm(const glm::vec3 &direction, float share) const {
	return parts ? parts->arm(direction, share) : share * direction;
}

bool PlantView::hold_skeleton() {
	const bool is_news = !is_held;
	is_held = true;
	return is_news;
}

MeshInstance3D *PlantView::get_mesh_instance() const {
	return Object::cast_to<MeshInstance3D>(ObjectDB::get_instance(mesh_instance));
}

void PlantView::make_children() {
	skeleton = new_node<Skeleton3D>();
	skeleton->set_name(SKELETON_NAME);
	motion.bone().posed = { 0.0f, 1.0f, 0.0f };
	is_held = false;
	make_mesh_instance();
	node->add_child(skeleton, false, Node::INTERNAL_MODE_FRONT);
}

void PlantView::make_mesh_instance() {
	MeshInstance3D *made = new_node<MeshInstance3D>();
	made->set_name(MESH_NAME);
	skeleton->add_child(made, false, Node::INTERNAL_MODE_FRONT);
	made->set_skeleton_path(NodePath(".."));
	mesh_instance = made->get_instance_id();
}

// Binds the skeleton again. The next pose restores its bend.
void PlantView::set_up_bones() {
	const bool is_other = parts || skeleton->get_bone_count() != PartSkeleton::count(nullptr);
	PartSkeleton::set_up(skeleton, parts.get());
	get_mesh_instance()->set_skin(PartSkeleton::skin_of(parts.get()));
	if (is_other) {
		motion.bone().posed = glm::vec3(NAN);
	}
}

// Linear blend skinning moves no vertex farther from the root than its distance at rest. A plant on a slope, a wall or
// a ceiling may hang below its root, so the box includes all directions. The sides of a bent stem may extend beyond its
// end.
AABB PlantView::reach() const {
	if (mesh.is_null()) {
		return AABB();
	}
	const AABB rest = mesh->get_aabb();
	const Vector3 farthest = rest.position.abs().max(rest.get_end().abs());
	const float side = std::sqrt(farthest.x * farthest.x + farthest.z * farthest.z);
	const float radius = joint_count() > 0 ? farthest.y + side : farthest.length();
	return AABB(Vector3(-radius, -radius, -radius), Vector3(2.0f * radius, 2.0f * radius, 2.0f * radius));
}

} // namespace undergrowth

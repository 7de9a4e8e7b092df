#include "part_skeleton.hpp"

#include "convert.hpp"
#include "form/grown_plant.hpp"
#include "new_object.hpp"
#include "shared_resources.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

#include <glm/geometric.hpp>

#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr float CALM_BEND = 1.5e-3f; // Where part_bend() says that a stem rests, and less.
static constexpr float CALM_RATE = 1e-4f; // 1/s: no part bends as far as a millionth by it.
static const char *const OWN_BONES[] = { "root", "tip" };

static Transform3D transform_of(const PartPose &pose) {
	const Quaternion turn(pose.turn.x, pose.turn.y, pose.turn.z, pose.turn.w);
	return Transform3D(Basis(turn).scaled(Vector3(pose.size, pose.size, pose.size)), to_godot(pose.shift));
}

std::unique_ptr<PartSkeleton> PartSkeleton::of(const SampledPlant &sampled) {
	if (!sampled.grown || !sampled.has_part_bones || sampled.grown->bones.bones().empty()) {
		return nullptr;
	}
	auto made = std::make_unique<PartSkeleton>();
	made->bones = sampled.grown->bones.stretched(sampled.height / sampled.grown->form.height);
	for (const std::string &name : sampled.grown->bones.names()) {
		made->names.push_back(String::utf8(name.c_str()));
	}
	made->skin = new_counted<Skin>();
	made->skin->add_bind(FormBones::ROOT, Transform3D());
	made->skin->add_bind(FormBones::TIP, Transform3D());
	for (size_t i = 0; i < made->bones.size(); i++) {
		made->skin->add_bind(int(FormBones::FIRST + i), Transform3D(Basis(), -to_godot(made->bones[i].origin)));
	}
	return made;
}

Ref<Skin> PartSkeleton::skin_of(const PartSkeleton *parts) {
	return parts ? parts->skin : plant_skin();
}

int PartSkeleton::count(const PartSkeleton *parts) {
	return FormBones::FIRST + (parts ? int(parts->bones.size()) : 0);
}

// In the axes of the bone that carries it.
Transform3D PartSkeleton::rest(size_t bone) const {
	const int outer_of = bones[bone].outer_of;
	const glm::vec3 carrier = outer_of < 0 ? glm::vec3(0.0f) : bones[size_t(outer_of)].origin;
	return Transform3D(Basis(), to_godot(bones[bone].origin - carrier));
}

void PartSkeleton::set_up(Skeleton3D *skeleton, const PartSkeleton *parts) {
	bool are_same = skeleton->get_bone_count() == count(parts);
	for (int i = 0; are_same && parts && i < int(parts->bones.size()); i++) {
		are_same = skeleton->get_bone_name(FormBones::FIRST + i) == parts->names[size_t(i)];
	}
	if (!are_same) {
		skeleton->clear_bones();
		for (const char *name : OWN_BONES) {
			skeleton->add_bone(name);
		}
		skeleton->set_bone_parent(FormBones::TIP, FormBones::ROOT);
		for (size_t i = 0; parts && i < parts->bones.size(); i++) {
			const int outer_of = parts->bones[i].outer_of;
			skeleton->add_bone(parts->names[i]);
			skeleton->set_bone_parent(
					int(FormBones::FIRST + i), outer_of < 0 ? FormBones::TIP : FormBones::FIRST + outer_of);
		}
	}
	for (size_t i = 0; parts && i < parts->bones.size(); i++) {
		skeleton->set_bone_rest(int(FormBones::FIRST + i), parts->rest(i));
		skeleton->set_bone_pose(int(FormBones::FIRST + i), parts->rest(i));
	}
}

bool PartSkeleton::is_calm() const {
	return glm::distance(stem.bend, stem.rest) < CALM_BEND && glm::length(stem.rate) < CALM_RATE;
}

void PartSkeleton::pose(Skeleton3D *skeleton) const {
	if (skeleton->get_bone_count() != count(this)) {
		return; // A script has changed it.
	}
	const glm::vec2 s = stem.bend;
	const float scale = 1.0f / std::sqrt(1.0f + glm::dot(s, s));
	const Quaternion to_tip(-s.y * scale, 0.0f, s.x * scale, scale);
	std::vector<Transform3D> posed(bones.size()); // In the plant's axes.
	for (size_t i = 0; i < bones.size(); i++) {
		const int outer_of = bones[i].outer_of;
		posed[i] = transform_of(pose_of(bones[i], stem)) * Transform3D(Basis(), to_godot(bones[i].origin));
		const Transform3D to_carrier =
				outer_of < 0 ? Transform3D(Basis(to_tip)) : posed[size_t(outer_of)].affine_inverse();
		skeleton->set_bone_pose(int(FormBones::FIRST + i), to_carrier * posed[i]);
	}
}

void PartSkeleton::pose(const RID &drawn) const {
	RenderingServer *server = RenderingServer::get_singleton();
	for (size_t i = 0; i < bones.size(); i++) {
		server->skeleton_bone_set_transform(drawn, int(FormBones::FIRST + i), transform_of(pose_of(bones[i], stem)));
	}
}

} // namespace undergrowth

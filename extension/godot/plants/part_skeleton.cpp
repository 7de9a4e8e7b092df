#include "plants/part_skeleton.hpp"

#include "base/convert.hpp"
#include "base/new_object.hpp"
#include "form/grown_plant.hpp"
#include "species/shared_resources.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace godot;

namespace undergrowth {

static constexpr float CALM_BEND = 1.5e-3f; // At or below the limit where part_bend() treats a stem as resting.
static constexpr float MIN_HEIGHT = 1e-3f; // Of a unit direction, plus 1.
static constexpr float CALM_AIR = 0.015f; // m/s: below the onset of every part (0.125 Hz and more).
static constexpr float CALM_RATE = 1e-4f; // 1/s: bends a part by less than a millionth.

static Quaternion quaternion_of(const glm::vec4 &turn) {
	return Quaternion(turn.x, turn.y, turn.z, turn.w);
}

static Transform3D transform_of(const PartPose &pose) {
	const Vector3 size(pose.size, pose.size, pose.size);
	return Transform3D(Basis(quaternion_of(pose.turn)).scaled(size), to_godot(pose.shift));
}

std::unique_ptr<PartSkeleton> PartSkeleton::of(const SampledPlant &sampled) {
	const FormBones *const of_parts = sampled.part_bones();
	if (!of_parts && !sampled.stem) {
		return nullptr;
	}
	auto made = std::make_unique<PartSkeleton>();
	made->height = sampled.height;
	made->add_bone("root", -1, Vector3());
	made->add_bone("tip", FormBones::ROOT, Vector3());
	if (sampled.stem) {
		made->constants = sampled.stem;
		made->joints = sampled.stem->joints;
		made->add_stem();
	}
	if (of_parts) {
		made->bones = of_parts->stretched(sampled.height / sampled.bones_height());
	}
	for (size_t i = 0; i < made->bones.size(); i++) {
		const PartBone &bone = made->bones[i];
		made->add_bone(String::utf8(of_parts->names()[i].c_str()), made->carrier_of(bone), to_godot(bone.origin));
	}
	made->skin = new_counted<Skin>();
	for (size_t i = 0; i < made->origins.size(); i++) {
		made->skin->add_bind(int(i), Transform3D(Basis(), -made->origins[i]));
	}
	made->posed.resize(made->origins.size());
	return made;
}

std::vector<Transform3D> PartSkeleton::at_rest(const SampledPlant &sampled) {
	const std::unique_ptr<PartSkeleton> parts = of(sampled);
	if (!parts) {
		return { Transform3D(), Transform3D(Basis(quaternion_of(sampled.rest))) };
	}
	parts->stem.bend = sampled.rest;
	parts->stem.rest = sampled.rest;
	parts->update(true);
	std::vector<Transform3D> all;
	for (size_t i = 0; i < parts->posed.size(); i++) {
		all.push_back(parts->posed[i] * Transform3D(Basis(), -parts->origins[i]));
	}
	return all;
}

void PartSkeleton::add_bone(const String &name, int parent, const Vector3 &origin) {
	names.push_back(name);
	parents.push_back(parent);
	origins.push_back(origin);
}

void PartSkeleton::add_stem() {
	for (int joint = 0; joint < joints; joint++) {
		add_bone("stem_" + String::num_int64(joint + 1), joint == 0 ? int(FormBones::ROOT) : FormBones::TIP + joint,
				Vector3(0.0f, height * float(joint) / float(joints), 0.0f));
	}
	parents[FormBones::TIP] = FormBones::TIP + joints;
	origins[FormBones::TIP] = Vector3(0.0f, height, 0.0f);
}

int PartSkeleton::carrier_of(const PartBone &bone) const {
	if (bone.outer_of >= 0) {
		return part_index(size_t(bone.outer_of));
	}
	if (bone.carried_by >= 0) {
		return part_index(size_t(bone.carried_by));
	}
	const int link = std::min(int(bone.stem_offset * float(joints)), joints - 1);
	return has_joints() ? FormBones::FIRST + link : int(FormBones::TIP);
}

Ref<Skin> PartSkeleton::skin_of(const PartSkeleton *parts) {
	return parts ? parts->skin : plant_skin();
}

int PartSkeleton::count(const PartSkeleton *parts) {
	return parts ? int(parts->names.size()) : int(FormBones::FIRST);
}

void PartSkeleton::set_up(Skeleton3D *skeleton, const PartSkeleton *parts) {
	static const char *const own[] = { "root", "tip" };
	const auto name_of = [&](int bone) { return parts ? parts->names[size_t(bone)] : String(own[bone]); };
	bool are_same = skeleton->get_bone_count() == count(parts);
	for (int i = 0; are_same && i < count(parts); i++) {
		are_same = skeleton->get_bone_name(i) == name_of(i);
	}
	if (!are_same) {
		skeleton->clear_bones();
		for (int i = 0; i < count(parts); i++) {
			skeleton->add_bone(name_of(i));
		}
	}
	if (!parts) {
		skeleton->set_bone_parent(FormBones::TIP, FormBones::ROOT);
		skeleton->set_bone_rest(FormBones::TIP, Transform3D());
		return;
	}
	for (int i = 1; i < count(parts); i++) {
		const int parent = parts->parents[size_t(i)];
		const Transform3D rest(Basis(), parts->origins[size_t(i)] - parts->origins[size_t(parent)]);
		skeleton->set_bone_parent(i, parent);
		skeleton->set_bone_rest(i, rest);
		skeleton->set_bone_pose(i, rest);
	}
}

glm::vec3 PartSkeleton::second_bend(const TipState &tip, const StemSecond &second) const {
	if (!constants || constants->modes < 2) {
		return glm::vec3(0.0f);
	}
	const glm::vec2 bend = stem_state(*constants, tip, stem.rest, second).place[1] * constants->mode[1].tip_slope;
	return turned({ bend.x, 0.0f, bend.y }, stem.rest);
}

bool PartSkeleton::is_calm() const {
	return glm::distance(stem.bend, stem.rest) < CALM_BEND && glm::length(stem.rate) < CALM_RATE &&
			glm::length(stem.second) < CALM_RATE && stem.air < CALM_AIR && stem.drops <= 0.0f;
}

glm::vec3 PartSkeleton::arm(const glm::vec3 &direction, float share) const {
	if (!has_joints()) {
		return share * direction;
	}
	StemMotion bent = stem;
	bent.bend = glm::vec2(direction.x, direction.z) / std::max(1.0f + direction.y, MIN_HEIGHT);
	return PosedStem(*constants, 1.0f, bent).place_of({ 0.0f, share, 0.0f }, share);
}

void PartSkeleton::update_stem(const PosedStem &posed_stem) {
	end = stem_links(*constants, posed_stem.amplitudes, links);
	const Quaternion lean = quaternion_of(stem.rest);
	for (int i = 0; i < joints; i++) {
		turns[i] = lean * quaternion_of(links[i].turn);
	}
	turns[joints] = quaternion_of(stem.bend);
}

void PartSkeleton::place_stem() {
	for (int i = 0; i < joints; i++) {
		posed[size_t(FormBones::FIRST + i)] =
				Transform3D(Basis(turns[i]), to_godot(turned(links[i].start * height, stem.rest)));
	}
	posed[FormBones::TIP] = Transform3D(Basis(turns[joints]), to_godot(turned(end * height, stem.rest)));
}

void PartSkeleton::update(bool needs_places) {
	std::optional<PosedStem> posed_stem;
	if (has_joints()) {
		posed_stem.emplace(*constants, height, stem);
		update_stem(*posed_stem);
		if (needs_places) {
			place_stem();
		}
	} else {
		posed[FormBones::TIP] = Transform3D(Basis(quaternion_of(stem.bend)));
	}
	for (size_t i = 0; i < bones.size(); i++) {
		const PartPose pose = posed_stem ? pose_of(bones[i], stem, *posed_stem) : pose_of(bones[i], stem);
		posed[size_t(part_index(i))] = transform_of(pose) * Transform3D(Basis(), to_godot(bones[i].origin));
	}
}

void PartSkeleton::pose(Skeleton3D *skeleton) {
	if (skeleton->get_bone_count() != count(this)) {
		return; // A script has changed the bones.
	}
	update(!bones.empty());
	Quaternion below;
	for (int i = 0; i < joints + 1 && has_joints(); i++) { // A joint remains at the end of the link below it.
		const int bone = i < joints ? FormBones::FIRST + i : int(FormBones::TIP);
		skeleton->set_bone_pose_rotation(bone, below.inverse() * turns[i]);
		below = turns[i];
	}
	for (int i = part_index(0); i < count(this); i++) {
		skeleton->set_bone_pose(i, posed[size_t(parents[size_t(i)])].affine_inverse() * posed[size_t(i)]);
	}
}

void PartSkeleton::pose(const RID &drawn) {
	update(true);
	RenderingServer *server = RenderingServer::get_singleton();
	for (int i = has_joints() ? FormBones::TIP : FormBones::FIRST; i < count(this); i++) {
		const Transform3D back(Basis(), -origins[size_t(i)]);
		server->skeleton_bone_set_transform(drawn, i, posed[size_t(i)] * back);
	}
}

} // namespace undergrowth

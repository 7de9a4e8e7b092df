#include "plant_bone.hpp"

#include "convert.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr int TIP_BONE = 1;
// Below this (radians, about) a change of the pose cannot be seen and is not worth an update of the skeleton.
static constexpr float SMALLEST_TURN = 1e-6f;
static constexpr float LEAST_HEIGHT = 1e-6f;

// The shortest turn from +Y to d = (x, y, z): axis (z, 0, -x), half-angle form (1 + y, axis)/norm.
static Quaternion turn_from_up(const glm::vec3 &d) {
	const float w = 1.0f + d.y;
	if (w < 1e-6f) {
		return Quaternion(1.0f, 0.0f, 0.0f, 0.0f);
	}
	const float scale = 1.0f / std::sqrt(w * w + d.x * d.x + d.z * d.z);
	return Quaternion(d.z * scale, 0.0f, -d.x * scale, w * scale);
}

static bool can_be_told_apart(const glm::vec3 &a, const glm::vec3 &b) {
	const glm::vec3 change = glm::abs(a - b);
	return !(change.x < SMALLEST_TURN && change.y < SMALLEST_TURN && change.z < SMALLEST_TURN);
}

static glm::vec2 bend_of(const glm::vec3 &direction) {
	const float scale = 1.0f / std::max(1.0f + direction.y, LEAST_HEIGHT);
	return { direction.x * scale, direction.z * scale };
}

void PlantBone::take(const glm::vec3 &local) {
	posed = local;
	node_is_behind = true;
	if (parts) {
		parts->stem.bend = bend_of(local);
	}
}

bool PlantBone::shows_parts(const glm::vec3 &direction) const {
	if (!parts || !skeleton || way == Way::UNSEEN) {
		return false;
	}
	return !parts->is_calm() || can_be_told_apart(to_glm(to_local.xform(to_godot(direction))), posed);
}

void PlantBone::follow_stem(const glm::vec3 &before, const glm::vec3 &after, float step, float clock) {
	const glm::vec2 from = bend_of(to_glm(to_local.xform(to_godot(before))));
	const glm::vec2 to = bend_of(to_glm(to_local.xform(to_godot(after))));
	parts->stem.rate = (to - from) / step;
	parts->stem.clock = clock;
}

void PlantBone::show(const glm::vec3 &direction) {
	if (!skeleton) {
		return;
	}
	if (way == Way::NODE) {
		turn_to(direction);
		// The renderer has the skeleton's bones from its first update on.
		if (!is_held && drawn.is_valid() &&
				RenderingServer::get_singleton()->skeleton_get_bone_count(drawn) == PartSkeleton::count(parts)) {
			way = Way::RENDERER;
		}
		return;
	}
	const glm::vec3 local = to_glm(to_local.xform(to_godot(direction)));
	const bool has_turned = can_be_told_apart(local, posed);
	if (!has_turned && (!parts || parts->is_calm())) {
		return;
	}
	take(local);
	if (way == Way::RENDERER) {
		if (has_turned) {
			RenderingServer::get_singleton()->skeleton_bone_set_transform(
					drawn, TIP_BONE, Transform3D(Basis(turn_from_up(local)), Vector3()));
		}
		if (parts) {
			parts->pose(drawn);
		}
	}
}

void PlantBone::turn_to(const glm::vec3 &direction) {
	const glm::vec3 local = to_glm(to_local.xform(to_godot(direction)));
	if (skeleton && (can_be_told_apart(local, posed) || (parts && !parts->is_calm()))) {
		take(local);
	}
	catch_up();
}

void PlantBone::catch_up() {
	if (skeleton && node_is_behind) {
		node_is_behind = false;
		skeleton->set_bone_pose_rotation(TIP_BONE, turn_from_up(posed));
		if (parts) {
			parts->pose(skeleton);
		}
	}
}

} // namespace undergrowth

#include "plant_bone.hpp"

#include "convert.hpp"

#include <glm/common.hpp>

#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr int TIP_BONE = 1;
// Below this (radians, about) a change of the pose cannot be seen and is not worth an update of the skeleton.
static constexpr float SMALLEST_TURN = 1e-6f;

// The shortest turn from +Y to d = (x, y, z): axis (z, 0, -x), half-angle form (1 + y, axis)/norm.
static Quaternion turn_from_up(const glm::vec3 &d) {
	const float w = 1.0f + d.y;
	if (w < 1e-6f) {
		return Quaternion(1.0f, 0.0f, 0.0f, 0.0f);
	}
	const float scale = 1.0f / std::sqrt(w * w + d.x * d.x + d.z * d.z);
	return Quaternion(d.z * scale, 0.0f, -d.x * scale, w * scale);
}

void PlantBone::turn_to(const glm::vec3 &direction) {
	if (!skeleton) {
		return;
	}
	const glm::vec3 local = to_glm(to_local.xform(to_godot(direction)));
	const glm::vec3 change = glm::abs(local - posed);
	if (change.x < SMALLEST_TURN && change.y < SMALLEST_TURN && change.z < SMALLEST_TURN) {
		return;
	}
	posed = local;
	skeleton->set_bone_pose_rotation(TIP_BONE, turn_from_up(local));
}

} // namespace undergrowth

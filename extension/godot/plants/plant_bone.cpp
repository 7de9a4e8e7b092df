#include "plants/plant_bone.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/rendering_server.hpp>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr int TIP_BONE = 1;
static constexpr float MIN_HEIGHT = 1e-6f;

static glm::vec2 bend_of(const glm::vec3 &direction) {
	const float scale = 1.0f / std::max(1.0f + direction.y, MIN_HEIGHT);
	return { direction.x * scale, direction.z * scale };
}

static Quaternion turn_from_up(const glm::vec3 &direction) {
	const bool is_down = 1.0f + direction.y < MIN_HEIGHT;
	return is_down ? Quaternion(1.0f, 0.0f, 0.0f, 0.0f) : quaternion_of(bend_of(direction));
}

void PlantBone::take(const glm::vec3 &local) {
	posed = local;
	node_is_behind = true;
	is_calm = true;
	if (parts && way != Way::UNSEEN) {
		parts->stem.bend = bend_of(local);
		is_calm = parts->is_calm();
	}
}

void PlantBone::follow(const Step &step) {
	const glm::vec2 from = bend_of(to_glm(to_local.xform(to_godot(step.before))));
	const glm::vec2 to = bend_of(to_glm(to_local.xform(to_godot(step.after))));
	parts->stem.rate = (to - from) / step.seconds;
	parts->stem.clock = step.clock;
	parts->stem.air = step.air;
	parts->stem.turns = step.turns;
	parts->stem.drops = step.drops;
	const glm::vec3 second = turned(to_glm(to_local.xform(to_godot(step.second))), -parts->stem.rest);
	parts->stem.second = { second.x, second.z };
}

glm::vec3 PlantBone::second_bend(const TipState &tip, const StemSecond &second) const {
	const auto own = [this](const glm::vec3 &v) { return to_glm(to_local.xform(to_godot(v))); };
	const glm::vec3 bend =
			parts->second_bend({ own(tip.direction), own(tip.rate) }, { own(second.bend), own(second.rate) });
	return to_glm(to_local.xform_inv(to_godot(bend)));
}

void PlantBone::show_local(const glm::vec3 &local) {
	if (way == Way::NODE && !may_leave_node()) {
		turn_to_local(local);
		return;
	}
	way = way == Way::NODE ? Way::RENDERER : way;
	take(local);
	if (way == Way::RENDERER) {
		if (!parts || !parts->has_joints()) {
			RenderingServer::get_singleton()->skeleton_bone_set_transform(
					drawn, TIP_BONE, Transform3D(Basis(turn_from_up(local)), Vector3()));
		}
		if (parts) {
			parts->pose(drawn);
		}
	}
}

// The renderer has the bones after the first update of the skeleton. A change of the node reaches it at the end of that
// frame and overwrites the pose. So the renderer alone is used from the next frame on.
bool PlantBone::may_leave_node() const {
	return !is_held && drawn.is_valid() && node_updated_in != Engine::get_singleton()->get_process_frames() &&
			RenderingServer::get_singleton()->skeleton_get_bone_count(drawn) == PartSkeleton::count(parts);
}

void PlantBone::turn_to(const glm::vec3 &direction) {
	way = way == Way::RENDERER ? Way::NODE : way;
	if (skeleton) {
		turn_to_local(to_glm(to_local.xform(to_godot(direction))));
	}
}

void PlantBone::turn_to_local(const glm::vec3 &local) {
	if (can_be_distinguished(local, posed) || !is_calm) {
		take(local);
	}
	catch_up();
}

void PlantBone::catch_up() {
	if (skeleton && node_is_behind) {
		node_is_behind = false;
		node_updated_in = Engine::get_singleton()->get_process_frames();
		if (!parts || !parts->has_joints()) {
			skeleton->set_bone_pose_rotation(TIP_BONE, turn_from_up(posed));
		}
		if (parts) {
			parts->stem.bend = bend_of(posed);
			parts->pose(skeleton);
		}
	}
}

} // namespace undergrowth

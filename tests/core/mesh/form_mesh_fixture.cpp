#include "form_mesh_fixture.hpp"

#include <glm/gtc/quaternion.hpp>

using namespace undergrowth;

glm::vec3 skinned(const BuiltForm &mesh, const FormBones &bones, size_t vertex, const StemMotion &stem) {
	const glm::vec3 &place = mesh.positions[vertex];
	glm::vec3 sum(0.0f);
	for (size_t k = 4 * vertex; k < 4 * vertex + 4; k++) {
		const int bone = mesh.bones[k];
		glm::vec3 at = bone == FormBones::TIP ? turned(place, stem.bend) : place;
		if (bone >= FormBones::FIRST) {
			const PartPose pose = pose_of(bones.bones()[static_cast<size_t>(bone - FormBones::FIRST)], stem);
			const glm::quat turn(pose.turn.w, pose.turn.x, pose.turn.y, pose.turn.z);
			at = pose.shift + pose.size * (turn * place);
		}
		sum += at * mesh.weights[k];
	}
	return sum;
}

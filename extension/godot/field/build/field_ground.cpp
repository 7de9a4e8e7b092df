#include "field/build/field_ground.hpp"

namespace undergrowth {

void FieldGround::look_up(
		const FieldPlants &plants, std::vector<float> &heights, std::vector<glm::vec3> &normals) const {
	if (kind == Kind::mesh) {
		const auto *corners = reinterpret_cast<const glm::vec3 *>(triangles.ptr());
		find_ground(corners, int(triangles.size() / 3), choice, plants, heights, normals);
	}
}

} // namespace undergrowth

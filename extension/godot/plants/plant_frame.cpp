#include "plants/plant_frame.hpp"

#include <cmath>

using namespace godot;

namespace undergrowth {

// The world's axes are used for rest directions above this height: up to 81 degrees from upright. So they include the
// species with the largest lean (80 degrees), as in fields.
static constexpr float LOWEST_REST = 0.15f;

PlantFrame frame_for(Law law, const Vector3 &rest) {
	if (law == Law::elasticity || rest.y > LOWEST_REST) {
		return PlantFrame::WORLD;
	}
	const Vector3 sizes = rest.abs();
	if (sizes.y >= sizes.x && sizes.y >= sizes.z) {
		return PlantFrame::DOWN;
	}
	if (sizes.x >= sizes.z) {
		return rest.x > 0.0f ? PlantFrame::TO_X : PlantFrame::FROM_X;
	}
	return rest.z > 0.0f ? PlantFrame::TO_Z : PlantFrame::FROM_Z;
}

const Basis &axes_of(PlantFrame frame) {
	static const Vector3 x(1.0f, 0.0f, 0.0f);
	static const Vector3 y(0.0f, 1.0f, 0.0f);
	static const Vector3 z(0.0f, 0.0f, 1.0f);
	static const Basis all[] = { Basis(), Basis(-y, x, z), Basis(y, -x, z), Basis(x, z, -y), Basis(x, -z, y),
		Basis(x, -y, -z) };
	return all[int(frame)];
}

} // namespace undergrowth

#include "field/view/plant_transforms.hpp"

#include "base/convert.hpp"
#include "placement/plant_axes.hpp"

#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr int FLOATS_PER_TRANSFORM = 12;

bool read_transforms(const Variant &from, std::vector<Transform3D> &to) {
	if (from.get_type() == Variant::PACKED_FLOAT32_ARRAY) {
		const PackedFloat32Array rows = from;
		const float *f = rows.ptr();
		for (int64_t i = 0; i + FLOATS_PER_TRANSFORM <= rows.size();
				i += FLOATS_PER_TRANSFORM, f += FLOATS_PER_TRANSFORM) {
			to.push_back(
					Transform3D(Basis(Vector3(f[0], f[4], f[8]), Vector3(f[1], f[5], f[9]), Vector3(f[2], f[6], f[10])),
							Vector3(f[3], f[7], f[11])));
		}
		return rows.size() % FLOATS_PER_TRANSFORM == 0;
	}
	if (from.get_type() != Variant::ARRAY) {
		return false;
	}
	const Array list = from;
	for (int64_t i = 0; i < list.size(); i++) {
		if (list[i].get_type() != Variant::TRANSFORM3D) {
			return false;
		}
		to.push_back(list[i]);
	}
	return true;
}

PlacedPlant place_transform(const Transform3D &transform) {
	const Basis &axes = transform.basis;
	return plant_of_axes(to_glm(transform.origin), to_glm(axes.get_column(1)), to_glm(axes.get_column(2)));
}

Transform3D drawn_transform(const PlacedPlant &plant) {
	const float c = plant.scale * std::cos(plant.turn);
	const float s = plant.scale * std::sin(plant.turn);
	const Vector3 up(0.0f, plant.scale, 0.0f);
	return Transform3D(Vector3(c, 0.0f, -s), up, Vector3(s, 0.0f, c), to_godot(plant.root));
}

Transform3D tilted(const Transform3D &placed, float tilt, float height) {
	const Vector3 aside = placed.basis.get_column(0) * tilt;
	Transform3D made = placed;
	made.basis.set_column(1, placed.basis.get_column(1) + aside);
	made.origin -= aside * height;
	return made;
}

} // namespace undergrowth

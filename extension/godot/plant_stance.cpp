#include "plant_stance.hpp"

#include "convert.hpp"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr int64_t STATE_FLOATS = 6;
static constexpr float SHORTEST = 1e-3f; // m.
static constexpr double LEAST_VOLUME = 1e-12; // Of a unit cube in the node's axes.

void PlantStance::follow(const Transform3D &global) {
	const float along = global.basis.get_column(1).length();
	root = to_glm(global.origin);
	if (std::fabs(global.basis.determinant()) < LEAST_VOLUME || !std::isfinite(along)) {
		return;
	}
	axes = global.basis.orthonormalized();
	scale_along = along;
}

float PlantStance::length_of(float height) const {
	return std::max(height > 0.0f ? height * scale_along : 1.0f, SHORTEST);
}

PackedFloat32Array PlantStance::floats_of(const TipState &state) const {
	const Vector3 parts[] = { axes.xform_inv(to_godot(state.direction)), axes.xform_inv(to_godot(state.rate)) };
	PackedFloat32Array floats;
	for (const Vector3 &part : parts) {
		for (int i = 0; i < 3; i++) {
			floats.push_back(part[i]);
		}
	}
	return floats;
}

bool PlantStance::read_state(const PackedFloat32Array &floats, TipState &into) const {
	if (floats.size() != STATE_FLOATS) {
		return false;
	}
	const Vector3 direction(floats[0], floats[1], floats[2]);
	const Vector3 rate(floats[3], floats[4], floats[5]);
	if (!direction.is_finite() || !rate.is_finite() || direction.is_zero_approx()) {
		return false;
	}
	into = { to_glm(axes.xform(direction.normalized())), to_glm(axes.xform(rate)) };
	return true;
}

} // namespace undergrowth

#include "plants/plant_transform.hpp"

#include "base/convert.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

using namespace godot;

namespace undergrowth {

static constexpr int64_t STATE_FLOATS = 12;
static constexpr int64_t TIP_FLOATS = 6; // Number of floats of the tip.
static constexpr float SHORTEST = 1e-3f; // m.
static constexpr double MIN_VOLUME = 1e-12; // Volume of a unit cube in the node's axes.

void PlantTransform::follow(const Transform3D &global) {
	const float along = global.basis.get_column(1).length();
	root = to_glm(global.origin);
	if (std::fabs(global.basis.determinant()) < MIN_VOLUME || !std::isfinite(along)) {
		return;
	}
	axes = global.basis.orthonormalized();
	scale_along = along;
}

float PlantTransform::length_of(float height) const {
	return std::max(height > 0.0f ? height * scale_along : 1.0f, SHORTEST);
}

PackedFloat32Array PlantTransform::floats_of(const MotionState &state) const {
	PackedFloat32Array floats;
	for (const glm::vec3 &part : { state.tip.direction, state.tip.rate, state.second.bend, state.second.rate }) {
		const Vector3 own = axes.xform_inv(to_godot(part));
		for (int i = 0; i < 3; i++) {
			floats.push_back(own[i]);
		}
	}
	return floats;
}

bool PlantTransform::read_state(const PackedFloat32Array &floats, MotionState &into) const {
	if (floats.size() != STATE_FLOATS && floats.size() != TIP_FLOATS) {
		return false;
	}
	Vector3 parts[STATE_FLOATS / 3];
	for (int64_t i = 0; i < floats.size(); i++) {
		parts[i / 3][i % 3] = floats[i];
	}
	const bool are_numbers = std::all_of(parts, std::end(parts), [](const Vector3 &part) { return part.is_finite(); });
	if (!are_numbers || parts[0].is_zero_approx()) {
		return false;
	}
	const auto outward = [this](const Vector3 &part) { return to_glm(axes.xform(part)); };
	into = { { outward(parts[0].normalized()), outward(parts[1]) }, { outward(parts[2]), outward(parts[3]) } };
	return true;
}

} // namespace undergrowth

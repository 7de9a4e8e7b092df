#pragma once

#include "field/field_view.hpp"

#include <godot_cpp/variant/transform3d.hpp>

#include <vector>

namespace undergrowth {

/// A plant as it is drawn at all levels of detail.
struct RankedPlant {
	godot::Transform3D transform;
	float rank = 0.0f;
	float height = 0.0f; ///< m.
	float reach = 0.0f; ///< m: as far from its root as its largest deflection takes it.
	float texel = 0.0f; ///< Where its pose is, as instances say it.
	float layer = 0.0f;
	int block = 0; ///< By its number in the list.
	int variant = 0;
};

/// All plants of some blocks that are not gone, by rank; equal ones in the order of their blocks. On any thread.
std::vector<RankedPlant> rank_plants(const FieldStyle &style, const std::vector<DrawnBlock> &blocks);

} // namespace undergrowth

#pragma once

#include "plant/motion.hpp"

#include <godot_cpp/variant/basis.hpp>

#include <cstdint>

namespace undergrowth {

/// The axes in which a plant's directions are simulated. The spring law is defined on the half sphere around the
/// frame's up axis. If the rest direction is near the horizon or below it, the up axis is the nearest of the world's
/// six axes. So there are six frames, and plants on many slopes still share pages.
enum class PlantFrame : uint8_t { WORLD, TO_X, FROM_X, TO_Z, FROM_Z, DOWN };

/// Returns the frame for a plant with the rest direction `rest` (unit, world axes).
PlantFrame frame_for(Law law, const godot::Vector3 &rest);
/// Returns the axes of a frame, in the world's.
const godot::Basis &axes_of(PlantFrame frame);

} // namespace undergrowth

#pragma once

#include "plant/motion.hpp"

#include <godot_cpp/variant/basis.hpp>

#include <cstdint>

namespace undergrowth {

/// The axes that a plant's directions are simulated in. The spring law lives on the half sphere about the frame's own
/// up, so a plant whose rest direction comes near the horizon, or below it, has the one of the world's six axes for up
/// that is nearest to its rest: six frames in all, so that plants on many slopes still share pages.
enum class PlantFrame : uint8_t { WORLD, TO_X, FROM_X, TO_Z, FROM_Z, DOWN };

/// The frame for a plant that rests along `rest` (unit, world axes).
PlantFrame frame_for(Law law, const godot::Vector3 &rest);
/// Its axes, in the world's.
const godot::Basis &axes_of(PlantFrame frame);

} // namespace undergrowth

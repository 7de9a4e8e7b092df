#pragma once

#include "form/arrangement.hpp"

#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/string.hpp>

namespace undergrowth {

/// Changes an arrangement by the options of a PlantGrowth's verbs: from, to, turn, phase, per_node, angle, scale,
/// radius, dome, level_tops, tilt, deviation; angles in radians, a Vector2 runs from the first part to the last. Tells
/// what is wrong and what to do, or nothing.
godot::String read_options(const godot::Dictionary &options, Arrangement &into);

} // namespace undergrowth

#pragma once

#include "form/arrangement.hpp"

#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/string.hpp>

namespace undergrowth {

/// Sets an arrangement by the options of a PlantGrowth method: from, to, turn, phase, per_node, angle, scale, radius,
/// dome, level_tops, tilt, deviation. Angles are in radians. A Vector2 is the value of the first part and of the last.
/// Returns what is wrong and what to do, or an empty string.
godot::String read_options(const godot::Dictionary &options, Arrangement &into);

} // namespace undergrowth

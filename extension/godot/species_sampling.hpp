#pragma once

#include "form/part.hpp"
#include "sampled_plant.hpp"

#include <godot_cpp/variant/string.hpp>

namespace undergrowth {

class PlantFunction;

// Main thread: a species may be a script. What returns a text tells what is wrong and what to do, or nothing.

/// Of a number of segments along a plant.
godot::String find_level_problem(int segments);
/// Of a height in metres; 0 is the species' own.
godot::String find_height_problem(double height);
/// Asks the species for its height where `height` is 0.
godot::String sample_height(PlantFunction &species, double height, int64_t seed, SampledPlant &result);
/// Asks the four functions for height, base shape, widths and colours.
godot::String sample_lathe(PlantFunction &species, double height, int segments, int64_t seed, SampledPlant &result);
/// The stem of the four functions as a part.
godot::String sample_stem(PlantFunction &species, Part &into);

} // namespace undergrowth

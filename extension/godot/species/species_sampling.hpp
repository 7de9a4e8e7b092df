#pragma once

#include "form/part.hpp"
#include "species/sampled_plant.hpp"

#include <godot_cpp/variant/string.hpp>

namespace undergrowth {

class PlantFunction;

// Main thread: a species may be a script. Functions that return a text return what is wrong and what to do, or an empty
// string.

/// Checks a number of segments along a plant.
godot::String find_level_problem(int segments);
/// Checks a height in metres; 0 is the height that the species generates.
godot::String find_height_problem(double height);
/// Sets the height; 0 uses the height that the species generates.
godot::String sample_height(PlantFunction &species, double height, int64_t seed, SampledPlant &result);
/// Samples height, base shape, widths and colors with the four functions.
godot::String sample_lathe(PlantFunction &species, double height, int segments, int64_t seed, SampledPlant &result);
/// Samples the stem of the four functions as a part.
godot::String sample_stem(PlantFunction &species, Part &into);

} // namespace undergrowth

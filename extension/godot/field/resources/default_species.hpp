#pragma once

#include "species/plant_function.hpp"

namespace undergrowth {

/// Returns the species of a field with an empty list: the add-on's meadow grass. If its file is missing, returns a
/// GrassFunction and prints a warning that names `field`. Main thread. Call it during a build and not earlier, because
/// the file can only be loaded when all classes are registered.
godot::Ref<PlantFunction> default_species(const godot::Object *field);

} // namespace undergrowth

#pragma once

#include "species/plant_function.hpp"

namespace undergrowth {

/// Returns the grass of a field without listed species. Call it in a build and not earlier: a resource can be loaded
/// only when its classes are registered. If the add-on's file is missing, it warns with `field` and returns a
/// GrassFunction.
godot::Ref<PlantFunction> default_species(const godot::Object *field);

} // namespace undergrowth

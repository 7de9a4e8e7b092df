#pragma once

#include "plant_function.hpp"

namespace undergrowth {

/// What grows in a field where no species are listed. Not before it is planted: a resource may be loaded only once its
/// classes are known. Where the add-on's file is missing `field` warns of it.
godot::Ref<PlantFunction> usual_grass(const godot::Object *field);

} // namespace undergrowth
